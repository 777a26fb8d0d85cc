#pragma once
/// One stop of the aircraft: turn to a heading, read datum and compass, and turn the control that stands here. Enter goes on,
/// F2 reads again, F4 skips with a reason, F5 leaves a control as it is with a reason. Also the index after the check swing.

#include <QWidget>

#include "ui/guided/GuidedJob.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace lubberline::ui {

class GuidedStation : public QWidget {
    Q_OBJECT

public:
    explicit GuidedStation(GuidedJob& job, QWidget* parent = nullptr);

    /// Shows where the job stands; what is half typed for the same step stays.
    void refresh();
    void focusField();
    /// From a live input: fills the field, as if typed.
    void setDatum(double heading_deg);
    void setCompass(double heading_deg);

    void next();      ///< Enter
    void readAgain(); ///< F2: the last one, or the heading that was skipped last
    void readAgainAt(int station);
    void skip();      ///< F4
    void leaveAsIs(); ///< F5

signals:
    void failed(const QString& message);

private:
    enum class Asks { Nothing, SkipReason, LeaveReason };
    void build();
    void showReading(const StationState& station);
    void showTurn(const MakeCompassRead& turn);
    void showNoTurn();
    void say(const QString& message, bool urgent = false);
    [[nodiscard]] bool turning() const;
    [[nodiscard]] QWidget* firstEmpty() const;

    // GuidedStationTaken.cpp: what was typed becomes a step of the job
    void takeReading();
    void takeTurn();
    void takeReason();
    void ask(Asks what, const QString& question);
    void tell(job::What what);
    [[nodiscard]] Result<Entry> entry() const;

    GuidedJob& m_job;
    Asks m_asks = Asks::Nothing;
    std::pair<int, int> m_shown{-2, -1}; ///< station and corrections done, of what is typed
    QString m_kept;                      ///< the figures that were looked at again and are kept when Enter comes a second time
    QLabel* m_turnTo;
    QWidget* m_reading;
    QLineEdit* m_datum;
    QLabel* m_asternTitle;
    QLineEdit* m_astern;
    QLineEdit* m_compass;
    QWidget* m_turn;
    QLabel* m_sentence;
    QLabel* m_target;
    QLineEdit* m_after;
    QLineEdit* m_turnNote;
    QLabel* m_message;
    QWidget* m_reasonRow;
    QLabel* m_question;
    QLineEdit* m_reason;
    QPushButton *m_next, *m_again, *m_skip, *m_leave;
};

} // namespace lubberline::ui
