#pragma once
/// The pages that were opened, one of them in front. Each is made when it is first needed; one that owns a record is made anew for
/// another record, and the old one goes with whatever was typed or opened on it.

#include <QPointer>
#include <QStackedWidget>

#include <map>
#include <set>
#include <vector>

#include "core/angle/AngleText.h"
#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

class PageStack : public QStackedWidget {
    Q_OBJECT

public:
    /// @param context what pages are made of; it and its window outlive the stack.
    PageStack(PageContext& context, std::vector<PageDescription> pages, QWidget* parent = nullptr);
    /// Pages that go tell nobody.
    ~PageStack() override;

    [[nodiscard]] const std::vector<PageDescription>& descriptions() const { return m_descriptions; }
    /// Of the page in front; none before one was shown.
    [[nodiscard]] const PageDescription* description() const;
    [[nodiscard]] Page& current() const { return static_cast<Page&>(*currentWidget()); }
    /// Puts the page of a destination in front, with its record on it. Errors: those of Page::open(); what was shown stays then.
    Result<void> show(const Destination& destination);
    using QStackedWidget::show;
    /// Puts a page in front as it was left. @return false: it was not opened, or its record is no more
    bool showAsLeft(const QString& id);
    /// One whose record is no more goes, unless it is in front.
    void drop(const QString& id);
    void fleetChanged(); ///< the page in front hears of it at once, another when it comes to the front
    void setAngleStyle(AngleStyle style);

signals:
    void readOut(const QString& text);
    void failed(const QString& message);
    void stateChanged();
    void turned();                                                   ///< another page, or another record on it
    void leftBehind(const QString& title, const QStringList& texts); ///< what was refused on a page that goes
    void titled();                                                   ///< the page in front has another title

private:
    [[nodiscard]] const PageDescription& descriptionOf(const Destination& destination) const;
    Page* make(const PageDescription& description);
    void retire(Page* page); ///< takes it out of the window at once
    void turnTo(Page& page);

    PageContext& m_context;
    std::vector<PageDescription> m_descriptions;
    std::map<QString, Page*> m_made;
    std::vector<QPointer<Page>> m_retired;
    std::set<Page*> m_stale; ///< those that have not heard yet that the fleet has changed
};

} // namespace lubberline::ui
