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
constexpr int kSoon_ms = 300; // one drag is many changes

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
    const QPoint last = room.bottomRight() - QPoint(m_window.width(), m_window.height());
    m_window.move(std::clamp(m_window.x(), room.left(), std::max(room.left(), last.x())),
        std::clamp(m_window.y(), room.top(), std::max(room.top(), last.y())));
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
