#pragma once

#include <QFrame>

class QLabel;
class QLineEdit;
class QPushButton;

namespace lubberline::ui {

/// Asks, beneath the table, why a reading is left out: without a reason it is not.
class ExclusionPanel : public QFrame {
    Q_OBJECT

public:
    explicit ExclusionPanel(QWidget* parent = nullptr);
    /// Opens for a row; `place` is its heading in words.
    void ask(int row, const QString& place);

signals:
    void reasonGiven(int row, const QString& reason);
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void finish();
    int m_row = -1;
    QLabel* m_question;
    QLineEdit* m_reason;
    QPushButton* m_exclude;
};

} // namespace lubberline::ui
