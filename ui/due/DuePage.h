#pragma once
/// What is due in the fleet: a list with filters, the waivers that answer events, the calendar rules, and the list as a
/// calendar file.

#include <functional>
#include <memory>

#include "ui/due/DueWork.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QUndoStack;

namespace lubberline::ui {

class DueRulesTable;

class DuePage : public Page {
    Q_OBJECT

public:
    /// @param today UTC.
    DuePage(EditContext& context, QUndoStack& undo, std::function<Date()> today, FileQuestions questions, QWidget* parent = nullptr);
    using QWidget::show;
    void show(std::shared_ptr<const DueNews> news);

    static PageDescription description(PageContext& context);
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }

signals:
    void openCompass(lubberline::AircraftId aircraft, lubberline::CompassId compass);
    void done(const QString& message); ///< the calendar is written

protected:
    void anglesChanged() override { fill(); }

private:
    void build();
    QWidget* buildList();
    void fill();
    void showFlags();
    void waive();
    void exportCalendar();
    [[nodiscard]] bool wanted(const DueLine& line) const;
    void keepChoice();
    void offerWaiver();
    [[nodiscard]] const DueLine* current() const;
    [[nodiscard]] const DueFlag* currentFlag() const;

    db::Stores& m_stores;
    std::function<Date()> m_today;
    FileQuestions m_questions;
    std::shared_ptr<const DueNews> m_news;
    std::vector<const DueLine*> m_shown;
    CompassId m_chosen; ///< kept when the list is found anew: a waiver must not slip to another event
    RecordId m_chosenEvent;
    QComboBox* m_state;
    QComboBox* m_type;
    QLineEdit* m_words;
    QTableWidget* m_table;
    QLabel* m_count;
    QTableWidget* m_flags;
    QLineEdit* m_reason;
    QLineEdit* m_by;
    QPushButton* m_waive;
    QPushButton* m_open;
    DueRulesTable* m_rules;
};

} // namespace lubberline::ui
