#pragma once
/// The help: topics at the left, the one that is chosen at the right.

#include <memory>

#include "ui/help/HelpTopics.h"
#include "ui/kit/Page.h"

class QListWidget;
class QPushButton;
class QTextBrowser;

namespace lubberline::ui {

class HelpPage : public Page {
    Q_OBJECT

public:
    /// @param wanted the topic that it opens with; empty: as it was left.
    HelpPage(PageContext& context, std::shared_ptr<QString> wanted, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] QString topic() const; ///< HelpTopic::id

private:
    void showTopic();
    void saveText();

    PageContext& m_context;
    std::shared_ptr<QString> m_wanted;
    std::vector<HelpTopic> m_topics;
    QListWidget* m_list;
    QTextBrowser* m_text;
    QPushButton *m_copy, *m_save;
};

} // namespace lubberline::ui
