#pragma once
/// Cells of the figures of one record, three in a row.

#include <QGridLayout>
#include <QWidget>

#include "ui/sensor/SensorParameters.h"

namespace lubberline::ui {

/// `play` gets what is to be done to the record; `settle` the figure's meaning. The grid must live as long as its widget.
template <class Record>
class ParameterGrid {
public:
    using Play = std::function<void(const std::function<void(Record&)>& change)>;
    using Settle = std::function<void(const QString& what)>;

    ParameterGrid(std::vector<Parameter<Record>> parameters, Play play, Settle settle);
    ParameterGrid(const ParameterGrid&) = delete;
    ParameterGrid& operator=(const ParameterGrid&) = delete;

    void show(const Record& record);
    [[nodiscard]] QWidget* widget() const { return m_widget; }

private:
    struct Shown {
        Parameter<Record> parameter;
        ParameterCell* cell;
    };
    QWidget* m_widget = new QWidget;
    std::vector<Shown> m_cells;
    Play m_play;
};

template <class Record>
ParameterGrid<Record>::ParameterGrid(std::vector<Parameter<Record>> parameters, Play play, Settle settle) : m_play(std::move(play))
{
    auto* layout = new QGridLayout(m_widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(6);
    layout->setVerticalSpacing(2);
    m_cells.reserve(parameters.size());
    for (Parameter<Record>& parameter : parameters) {
        const int place = static_cast<int>(m_cells.size());
        auto* cell = new ParameterCell(parameter.spec);
        layout->addWidget(cell, place / 3, place % 3);
        QObject::connect(cell, &ParameterCell::played, cell, [this, place](double value) {
            m_play([this, place, value](Record& record) { m_cells[static_cast<std::size_t>(place)].parameter.set(record, value); });
        });
        QObject::connect(cell, &ParameterCell::settled, cell, [settle, what = parameter.spec.meaning] { settle(what); });
        m_cells.push_back({std::move(parameter), cell});
    }
}

template <class Record>
void ParameterGrid<Record>::show(const Record& record)
{
    for (const Shown& shown : m_cells)
        shown.cell->setValue(shown.parameter.get(record));
}

} // namespace lubberline::ui
