#pragma once
/// The list of actions of an interference test, written while it runs: start it with the log, type what is switched, Enter. What is noted is
/// kept from one start of the program to the next, until it is cleared.

#include <QWidget>

#include <optional>

#include "core/base/Clock.h"
#include "core/calibration/Interference.h"
#include "ui/kit/FileQuestions.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSettings;
class QTableWidget;

namespace lubberline::ui {

class LiveActions : public QWidget {
    Q_OBJECT

public:
    /// @param clock, settings outlive it
    LiveActions(QSettings& settings, FileQuestions questions, const Clock& clock, QWidget* parent = nullptr);

    [[nodiscard]] const std::vector<TimedAction>& actions() const { return m_actions; }

signals:
    void saved(const QString& path);
    void failed(const QString& message);

private:
    void start();
    void note();
    void clear();
    void save();
    void keep();
    void recall();
    void showActions();

    QSettings& m_settings;
    FileQuestions m_questions;
    const Clock& m_clock;
    std::optional<Clock::Time> m_start; ///< none: not started
    std::vector<TimedAction> m_actions;
    QPushButton *m_begin, *m_save, *m_clear;
    QLineEdit* m_action;
    QLabel* m_words;
    QTableWidget* m_table;
};

} // namespace lubberline::ui
