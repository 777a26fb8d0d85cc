#pragma once
/// A window for the crew's second screen: only the next heading, and the figure that the compass is to be made to read.

#include <QWidget>

namespace lubberline::ui {

class FittedText;
class GuidedJob;

class CrewDisplay : public QWidget {
    Q_OBJECT

public:
    explicit CrewDisplay(GuidedJob& job);
    void refresh();
    /// On the second screen where there is one, over all of it. It never takes the keyboard.
    void open();

protected:
    void keyPressEvent(QKeyEvent* event) override; ///< Escape and F11 close it

private:
    GuidedJob& m_job;
    FittedText* m_what;
    FittedText* m_figure;
    FittedText* m_detail;
};

} // namespace lubberline::ui
