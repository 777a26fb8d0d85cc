#pragma once
/// The line of sight of a helmet, from two sensors to a turret: type what they are and where one looks, and read what makes it wrong. It
/// follows what is typed.

#include <functional>
#include <vector>

#include "core/calibration/LineOfSight.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class DrawnPlot;

class LineOfSightPage : public Page {
    Q_OBJECT

public:
    /// @param now the time in words, for what is printed
    LineOfSightPage(FileQuestions questions, std::function<QString()> now, QWidget* parent = nullptr);
    ~LineOfSightPage() override;

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem&) override { return {}; }
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] Plot* plot() const override;
    void writeReport();

private:
    struct Typed {
        SightCase given;
        SightAngles look;
        double helmetRoll_deg = 0;
    };

    void build();
    QLineEdit* addLine(QFormLayout& form, const QString& title, const char* name, const QString& text);
    QPushButton* addIron(QFormLayout& form, const QString& title, const char* name, SensorModel& iron);
    void chooseIron(QPushButton& button, SensorModel& iron);
    /// What was typed; where a line does not stand, the reason.
    [[nodiscard]] Result<Typed> typed() const;
    void showBudget();
    void anglesChanged() override { showBudget(); }

    FileQuestions m_questions;
    std::function<QString()> m_now;
    QLineEdit *m_field = nullptr, *m_aircraft = nullptr, *m_look = nullptr, *m_turret = nullptr, *m_turretError = nullptr,
              *m_noise = nullptr, *m_tilt = nullptr, *m_cockpit = nullptr;
    SensorModel m_aircraftIron, m_helmetIron;
    DrawnPlot* m_plot;
    QTableWidget* m_causes;
    QLabel* m_words;
};

} // namespace lubberline::ui
