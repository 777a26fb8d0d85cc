#pragma once
/// What stops a guided swing: the fault and what was done about it, or why the swing is given up.

#include <QWidget>

#include "ui/guided/GuidedJob.h"

class QLabel;
class QLineEdit;

namespace lubberline::ui {

class GuidedFault : public QWidget {
    Q_OBJECT

public:
    explicit GuidedFault(GuidedJob& job, QWidget* parent = nullptr);

    /// Asks what the fault is.
    void ask();
    /// Shows the fault, or why the swing was abandoned, as the job has it.
    void refresh();

signals:
    void failed(const QString& message);
    void givenUp(); ///< it is a step of the job by now

private:
    void build();
    void say(const QString& words);
    void tell();
    void giveUp();
    [[nodiscard]] std::string typed() const;

    GuidedJob& m_job;
    QLabel* m_text;
    QLineEdit* m_line;
};

} // namespace lubberline::ui
