#pragma once
/// Where a coefficient comes from, with the figures of the swing: the formula, what each reading adds, and the interval. Escape closes it.

#include <QFrame>

#include <memory>

#include "core/swing/Analysis.h"

class QTextBrowser;

namespace lubberline::ui {

/// Which number of the table of coefficients.
struct CoefficientPlace {
    enum class Kind { Approximate, Exact, Rule };
    Kind kind = Kind::Approximate;
    Coefficient coefficient = Coefficient::A;
};

/// As HTML; what cannot be told says so.
[[nodiscard]] QString derivationHtml(const Analysis& analysis, CoefficientPlace place);

class DerivationPanel : public QFrame {
    Q_OBJECT

public:
    explicit DerivationPanel(QWidget* parent = nullptr);
    void show(const std::shared_ptr<const Analysis>& analysis, CoefficientPlace place);
    /// The same number of other readings; without any it closes.
    void refresh(const std::shared_ptr<const Analysis>& analysis);

signals:
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void close();
    CoefficientPlace m_place;
    QTextBrowser* m_text;
};

} // namespace lubberline::ui
