#include "ui/earth/FieldValues.h"

#include <QHeaderView>

#include "core/earth/FieldModel.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/TableFit.h"

namespace lubberline::ui {

namespace {

enum Column { Value, Rate, Uncertainty, kColumns };
constexpr int kRows = 7;

} // namespace

FieldValues::FieldValues(QWidget* parent) : QTableWidget(kRows, kColumns, parent)
{
    setAccessibleName(tr("Elements of the Earth's field"));
    wrapHeadings(*this); // before its height is asked
    setHorizontalHeaderLabels({tr("value"), tr("a year"), tr("± 1 σ")});
    setVerticalHeaderLabels({tr("X north (nT)"), tr("Y east (nT)"), tr("Z down (nT)"), tr("H horizontal (nT)"), tr("F total (nT)"),
        tr("D east + (°)"), tr("I down + (°)")});
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    const int height = fontMetrics().height() + 6;
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(height);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedHeight(heightOfRows(*this, kRows) + 2);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            setItem(row, column, new QTableWidgetItem);
            item(row, column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
    showNothing();
}

void FieldValues::showAnswer(const FieldAnswer& answer)
{
    const EarthField& field = answer.field;
    const auto sigma = [&answer](double FieldUncertainty::*member) {
        return answer.uncertainty ? std::optional((*answer.uncertainty).*member) : std::nullopt;
    };
    setRow(0, {field.north_nT, answer.rate.north_nT, sigma(&FieldUncertainty::north_nT), 1, true});
    setRow(1, {field.east_nT, answer.rate.east_nT, sigma(&FieldUncertainty::east_nT), 1, true});
    setRow(2, {field.down_nT, answer.rate.down_nT, sigma(&FieldUncertainty::down_nT), 1, true});
    setRow(3, {field.horizontal_nT(), answer.horizontalRate_nT, sigma(&FieldUncertainty::horizontal_nT), 1, false});
    setRow(4, {field.total_nT(), answer.totalRate_nT, sigma(&FieldUncertainty::total_nT), 1, false});
    setRow(5, {field.variation().degrees(), answer.declinationRate_deg, sigma(&FieldUncertainty::declination_deg), 2, true});
    setRow(6, {toDegrees(field.inclination_rad()), answer.inclinationRate_deg, sigma(&FieldUncertainty::inclination_deg), 2, true});
}

void FieldValues::setRow(int row, const Row& content)
{
    setText(row, Value,
        content.isSigned ? signedNumber(content.value, content.decimals) : QString::number(content.value, 'f', content.decimals));
    setText(row, Rate, signedNumber(content.rate, content.decimals + (content.decimals > 1 ? 1 : 0)));
    setText(row, Uncertainty,
        content.uncertainty ? QString::number(*content.uncertainty, 'f', content.decimals == 1 ? 0 : 2) : QStringLiteral("–"));
    item(row, Uncertainty)->setToolTip(content.uncertainty ? QString() : tr("This model states no uncertainty"));
}

void FieldValues::showNothing()
{
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
            setText(row, column, QStringLiteral("–"));
}

void FieldValues::setText(int row, int column, const QString& text) { item(row, column)->setText(text); }

} // namespace lubberline::ui
