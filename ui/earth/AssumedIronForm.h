#pragma once
/// How large the parts are taken to be that a swing cannot tell apart: as the command predict takes them.

#include <QObject>

#include <array>

#include "core/base/Result.h"
#include "core/swing/IronPosterior.h"

class QFormLayout;
class QLineEdit;

namespace lubberline::ui {

class AssumedIronForm : public QObject {
    Q_OBJECT

public:
    /// Adds its lines to a form.
    explicit AssumedIronForm(QFormLayout& form, QObject* parent);

    /// Errors: InvalidInput, naming the line.
    [[nodiscard]] Result<AssumedIron> assumed() const;

signals:
    void changed();

private:
    struct Size {
        QString name;
        double AssumedIron::*value;
        QLineEdit* line = nullptr;
    };
    std::array<Size, 4> m_sizes;
};

} // namespace lubberline::ui
