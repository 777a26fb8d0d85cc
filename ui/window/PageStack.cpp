#include "ui/window/PageStack.h"

#include <QApplication>

#include <algorithm>

#include "core/base/Contract.h"
#include "ui/kit/fit/ControlFit.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

PageStack::PageStack(PageContext& context, std::vector<PageDescription> pages, QWidget* parent)
    : QStackedWidget(parent)
    , m_context(context)
    , m_descriptions(std::move(pages))
{
    addWidget(new Page); // nothing yet: what to show is asked after the first paint
}

PageStack::~PageStack()
{
    for (const auto& [id, page] : m_made) {
        page->disconnect(this);
        page->disconnect(&m_context.window);
    }
    for (const auto& page : m_retired) // none of them outlives the database that it may have something to store in
        delete page;
}

const PageDescription& PageStack::descriptionOf(const Destination& destination) const
{
    const auto found = std::find_if(m_descriptions.begin(), m_descriptions.end(), [&](const PageDescription& page) {
        return destination.page.isEmpty() ? page.shows && page.shows(destination.record) : page.id == destination.page;
    });
    LUBBERLINE_EXPECT(found != m_descriptions.end(), "a destination is a page that is listed, or a record that one of them shows");
    return *found;
}

const PageDescription* PageStack::description() const
{
    for (const PageDescription& description : m_descriptions)
        if (const auto made = m_made.find(description.id); made != m_made.end() && made->second == currentWidget())
            return &description;
    return nullptr;
}

Page* PageStack::make(const PageDescription& description)
{
    Page* page = description.make();
    connect(page, &Page::readOut, this, &PageStack::readOut);
    connect(page, &Page::failed, this, &PageStack::failed);
    connect(page, &Page::stateChanged, this, &PageStack::stateChanged);
    connect(page, &QWidget::windowTitleChanged, this, &PageStack::titled);
    return page;
}

Result<void> PageStack::show(const Destination& destination)
{
    const PageDescription& description = descriptionOf(destination);
    const auto made = m_made.find(description.id);
    Page* before = made == m_made.end() ? nullptr : made->second;
    Page* page = before && before->isOf(destination.record) ? before : make(description);
    if (auto opened = page->open(destination.record); !opened) {
        if (page != before)
            delete page;
        return opened;
    }
    if (page != before)
        addWidget(page);
    m_made[description.id] = page;
    // Keys that were in the page before go to what is typed in this one, not to whichever button is the first of it.
    const QWidget* keys = QApplication::focusWidget();
    const bool hadKeys = keys && isAncestorOf(keys);
    turnTo(*page);
    if (before && page != before) {
        page->takeLook(*before);
        if (const QStringList texts = before->unstored(); !texts.isEmpty())
            emit leftBehind(before->title(), texts);
        retire(before);
    }
    if (destination.focus || description.focus || (hadKeys && page != before))
        page->setFocus();
    return {};
}

/// The old one may be in the middle of telling us something, so it goes when it has done; and a dialog that was opened from it (where a
/// report is to be written) comes back to it, while an import that ended beneath has shown another.
void PageStack::retire(Page* page)
{
    m_stale.erase(page);
    removeWidget(page);
    page->setParent(nullptr);
    page->disconnect(this);
    page->disconnect(&m_context.window);
    std::erase(m_retired, nullptr);
    m_retired.emplace_back(page);
    if (QWidget* asking = QApplication::activeModalWidget())
        connect(asking, &QObject::destroyed, page, &QObject::deleteLater);
    else
        page->deleteLater();
}

bool PageStack::showAsLeft(const QString& id)
{
    const auto made = m_made.find(id);
    if (made == m_made.end() || !made->second->shown().aircraft.valid())
        return false;
    turnTo(*made->second);
    return true;
}

void PageStack::drop(const QString& id)
{
    const auto made = m_made.find(id);
    if (made == m_made.end() || made->second == currentWidget())
        return;
    Page* page = made->second;
    m_made.erase(made);
    retire(page);
}

void PageStack::turnTo(Page& page)
{
    finishControls(page);
    setCurrentWidget(&page);
    if (m_stale.erase(&page) > 0)
        page.fleetChanged();
    emit turned();
}

void PageStack::fleetChanged()
{
    for (const auto& [id, page] : m_made)
        if (page != currentWidget())
            m_stale.insert(page);
    current().fleetChanged();
}

void PageStack::setAngleStyle(AngleStyle style)
{
    if (style == shownAngles())
        return;
    showAnglesIn(style);
    for (const auto& [id, page] : m_made)
        page->restyle();
}

} // namespace lubberline::ui
