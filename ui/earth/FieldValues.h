#pragma once

#include <QTableWidget>

#include <optional>

namespace lubberline {
struct FieldAnswer;
}

namespace lubberline::ui {

/// The elements of the Earth's field at a place: value, change a year, one standard deviation.
class FieldValues : public QTableWidget {
    Q_OBJECT

public:
    explicit FieldValues(QWidget* parent = nullptr);

    void showAnswer(const FieldAnswer& answer);
    /// Dashes: there is nothing to show.
    void showNothing();

private:
    struct Row {
        double value, rate;
        std::optional<double> uncertainty;
        int decimals;
        bool isSigned;
    };
    void setRow(int row, const Row& content);
    void setText(int row, int column, const QString& text);
};

} // namespace lubberline::ui
