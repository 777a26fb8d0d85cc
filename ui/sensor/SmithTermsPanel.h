#pragma once
/// What a level compass shows of a model: λ, the coefficients with the terms that each comes from, and what a swing can tell of
/// it.

#include <QWidget>

#include "core/base/Result.h"
#include "core/sensor/PoissonSmith.h"

class QLabel;
class QListWidget;
class QTableWidget;

namespace lubberline::ui {

class SmithTermsPanel : public QWidget {
    Q_OBJECT

public:
    explicit SmithTermsPanel(QWidget* parent = nullptr);

    /// Why there is none is said in its place.
    void show(const Result<PoissonSmith>& smith);
    /// The list beside it: for a swing of this model in this field.
    void showKnowledge(const Result<PoissonSmith>& smith, const MeridianField& field);

private:
    void showRows(const PoissonSmith& smith);

    QLabel* m_lambda;
    QTableWidget* m_table;
    QListWidget* m_knowledge;
};

} // namespace lubberline::ui
