#include "ui/window/Placement.h"

#include <QDockWidget>
#include <QEvent>
#include <QFileInfo>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QTimer>
#include <QUrl>

#include <algorithm>

#include "ui/fleet/FleetPanel.h"

namespace lubberline::ui {

namespace {

const QString kGeometry = QStringLiteral("window/geometry"), kState = QStringLiteral("window/state");
constexpr int kSoon_ms = 300;   // one drag is many changes
constexpr int kFramed_ms = 150; // a window manager has set its frame by then

/// Branches are named by ids, which another database gives to others: each file has its own.
QString branchesOf(const QString& database)
{
    const QString path = QFileInfo(database).canonicalFilePath();
    return QStringLiteral("tree/open/") + QString::fromLatin1(QUrl::toPercentEncoding(path.isEmpty() ? database : path));
}

} // namespace

Placement::Placement(QMainWindow& window, FleetPanel& tree, QSettings& settings, const QString& database)
    : QObject(&window)
    , m_window(window)
    , m_tree(tree)
    , m_settings(settings)
    , m_branches(branchesOf(database))
    , m_soon(new QTimer(this))
{
    m_soon->setSingleShot(true);
    m_soon->setInterval(kSoon_ms);
    connect(m_soon, &QTimer::timeout, this, &Placement::keep);
    connect(&tree, &FleetPanel::branchesChanged, m_soon, qOverload<>(&QTimer::start));
    window.installEventFilter(this);
    tree.parentWidget()->installEventFilter(this);
}

void Placement::restore()
{
    const QSize frame(20, 40);
    m_window.resize(QSize(1440, 860).boundedTo(m_window.screen()->availableSize() - frame)); // with a frame, on 1366×768 too
    m_window.restoreGeometry(m_settings.value(kGeometry).toByteArray());
    m_window.restoreState(m_settings.value(kState).toByteArray());
    if (m_window.isMaximized() || m_window.isFullScreen())
        return;
    const QRect room = m_window.screen()->availableGeometry();
    if (const QSize bounded = m_window.size().boundedTo(room.size() - frame); bounded != m_window.size())
        m_window.resize(bounded);
    bringInto(room, m_window.geometry());
}

/// Moved only where it has to be: a position that is set again before the frame is known would drift by it from start to start.
void Placement::bringInto(const QRect& room, const QRect& place)
{
    const QPoint last = room.bottomRight() + QPoint(1, 1) - QPoint(place.width(), place.height());
    const QPoint within(std::clamp(place.x(), room.left(), std::max(room.left(), last.x())),
        std::clamp(place.y(), room.top(), std::max(room.top(), last.y())));
    if (within != place.topLeft())
        m_window.move(within);
}

/// Once it is shown its frame is known: title and all are to be on the screen.
void Placement::bringOnScreen()
{
    if (m_window.isMaximized() || m_window.isFullScreen() || !m_window.isVisible())
        return;
    const QRect room = m_window.screen()->availableGeometry(), frame = m_window.frameGeometry();
    const QSize around = frame.size() - m_window.size(), most = room.size() - around;
    if (const QSize bounded = m_window.size().boundedTo(most); bounded != m_window.size())
        m_window.resize(bounded);
    bringInto(room, QRect(frame.topLeft(), m_window.size() + around));
}

/// A new user's tree is as wide as what stands in it, where the window has the room.
void Placement::restoreTree()
{
    auto* dock = qobject_cast<QDockWidget*>(m_tree.parentWidget());
    if (dock && !m_settings.contains(kState))
        m_window.resizeDocks(
            {dock}, {std::clamp(m_tree.wantedWidth(), dock->width(), std::max(dock->width(), m_window.width() * 3 / 10))}, Qt::Horizontal);
    m_tree.setOpenBranches(m_settings.value(m_branches).toStringList());
    m_treeFilled = true;
}

void Placement::keep()
{
    m_soon->stop();
    m_settings.setValue(kGeometry, m_window.saveGeometry());
    m_settings.setValue(kState, m_window.saveState());
    if (m_treeFilled)
        m_settings.setValue(m_branches, m_tree.openBranches());
}

bool Placement::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::Show && object == &m_window && !event->spontaneous())
        QTimer::singleShot(kFramed_ms, this, &Placement::bringOnScreen);
    switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::WindowStateChange:
    case QEvent::ShowToParent: // the dock, put away and fetched
    case QEvent::HideToParent:
        if (m_window.isVisible()) // shown or hidden as a whole it stands where it stood
            m_soon->start();
        break;
    default: break;
    }
    return QObject::eventFilter(object, event);
}

} // namespace lubberline::ui
