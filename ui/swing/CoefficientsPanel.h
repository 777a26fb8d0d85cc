#pragma once
/// The coefficients A…E: approximate and exact with their intervals, and by the point rule; each number opens where it comes from. What cannot be told is a dash with
/// its reason.

#include <QWidget>

#include <memory>

#include "core/swing/Analysis.h"
#include "ui/swing/DerivationPanel.h"

class QLabel;
class QTableWidget;

namespace lubberline::ui {

class CoefficientsPanel : public QWidget {
    Q_OBJECT

public:
    explicit CoefficientsPanel(QWidget* parent = nullptr);

    /// @param whyNone shown when there is no analysis.
    void show(const std::shared_ptr<const Analysis>& analysis, const QString& whyNone);
    using QWidget::show;

signals:
    /// A click, or Enter, on a number: where it comes from is wanted.
    void derivationWanted(lubberline::ui::CoefficientPlace place);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void askFor(int row, int column);
    void setCell(int row, int column, const QString& text, const QString& whyNone);
    void showFit(const SmithFitReport& fit, int column, double scale, int decimals, const QString& whyNone);
    void showPointRules(const std::optional<PointRules>& rules);

    QTableWidget* m_table;
    QLabel* m_summary;
    QLabel* m_limitations;
};

} // namespace lubberline::ui
