#include "ui/guided/CrewDisplay.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QScreen>
#include <QVBoxLayout>

#include "ui/guided/GuidedJob.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

/// Text as large as its room allows.
class FittedText : public QLabel {
public:
    using QLabel::QLabel;

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        QFont large = font();
        large.setPixelSize(100);
        const QSizeF at100 = QFontMetricsF(large).size(Qt::TextSingleLine, text().isEmpty() ? QStringLiteral("0") : text());
        const double fit = std::min(width() * 0.95 / at100.width(), height() * 0.9 / at100.height());
        large.setPixelSize(std::max(12, static_cast<int>(100 * fit)));
        painter.setFont(large);
        painter.drawText(rect(), Qt::AlignCenter, text());
    }
};

CrewDisplay::CrewDisplay(GuidedJob& job) : m_job(job), m_what(new FittedText), m_figure(new FittedText), m_detail(new FittedText)
{
    setObjectName(QStringLiteral("crewDisplay"));
    setWindowTitle(tr("Crew display"));
    QPalette colours = palette();
    colours.setColor(QPalette::Window, Qt::black);
    colours.setColor(QPalette::WindowText, Qt::white);
    setPalette(colours);
    m_what->setObjectName(QStringLiteral("crewWhat"));
    m_figure->setObjectName(QStringLiteral("crewFigure"));
    m_detail->setObjectName(QStringLiteral("crewDetail"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_what, 2);
    column->addWidget(m_figure, 6);
    column->addWidget(m_detail, 2);
    for (QLabel* label : {m_what, m_figure, m_detail})
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    // The keys stay with the window that the figures are typed in.
    setWindowFlag(Qt::WindowDoesNotAcceptFocus);
    setAttribute(Qt::WA_ShowWithoutActivating);
    setFocusPolicy(Qt::NoFocus);
    resize(QSize(900, 600).boundedTo(screen()->availableSize() / 2));
    connect(&job, &GuidedJob::changed, this, &CrewDisplay::refresh);
}

void CrewDisplay::refresh()
{
    if (!m_job.isOpen())
        return;
    const auto& state = m_job.state();
    const StationState* here = m_job.station();
    QString what = stepTitle(m_job), figure, detail;
    if (state.turn) {
        what = state.phase == JobPhase::Index ? tr("Turn the compass in its mount until it reads")
                                              : tr("Turn the %1 until the compass reads").arg(wordFor(state.turn->control));
        figure = figureText(state.turn->makeCompassRead_deg);
        detail = here ? tr("on %1").arg(stationHeading(here->station.nominal_deg)) : QString();
    } else if (here) {
        what = tr("Turn to");
        figure = stationHeading(here->station.nominal_deg);
        detail = stepTitle(m_job);
    }
    m_what->setText(what);
    m_figure->setText(figure);
    m_detail->setText(detail);
}

void CrewDisplay::open()
{
    refresh();
    const auto screens = QGuiApplication::screens();
    if (screens.size() > 1) {
        setGeometry(screens.at(1)->geometry());
        showFullScreen();
    } else {
        const QRect room = screens.front()->availableGeometry();
        move(room.right() - width(), room.top()); // beside the figures, where the screen is large enough
        show();
    }
    raise();
}

void CrewDisplay::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_F11)
        close();
    else
        QWidget::keyPressEvent(event);
}

} // namespace lubberline::ui
