#pragma once

#include <QFrame>

#include "core/record/Id.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace lubberline::ui {

/// Asks, beneath the table, why a reading is left out: without a reason it is not.
class ExclusionPanel : public QFrame {
    Q_OBJECT

public:
    explicit ExclusionPanel(QWidget* parent = nullptr);
    /// Opens for a reading, wherever it will stand by the time that a reason is given; `place` is its heading in words.
    void ask(ReadingId reading, const QString& place);
    [[nodiscard]] ReadingId reading() const { return m_reading; }

signals:
    void reasonGiven(lubberline::ReadingId reading, const QString& reason);
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void finish();
    ReadingId m_reading;
    QLabel* m_question;
    QLineEdit* m_reason;
    QPushButton* m_exclude;
};

} // namespace lubberline::ui
