#pragma once
/// The strips above the page while a file is imported.

#include <QFrame>

#include "ui/intake/ImportFile.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace lubberline::ui {

/// How far the work is, and a way to stop it.
class ProgressStrip : public QFrame {
    Q_OBJECT

public:
    explicit ProgressStrip(QWidget* parent = nullptr);
    void begin(const QString& what);
    void setPercent(int percent);

signals:
    void cancelled();

private:
    QLabel* m_what;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
};

/// Asks whose swing a CSV holds that does not say so itself.
class NamingStrip : public QFrame {
    Q_OBJECT

public:
    explicit NamingStrip(QWidget* parent = nullptr);
    /// @param suggestion what the window shows: proposed, never taken without being seen.
    void ask(const QString& path, const CsvParticulars& suggestion);

signals:
    void named(const QString& path, const lubberline::ui::CsvParticulars& particulars);

private:
    QString m_path;
    QLabel* m_question;
    QLineEdit* m_aircraft;
    QLineEdit* m_type;
    QLineEdit* m_compass;
};

} // namespace lubberline::ui
