#pragma once
/// Records of years on paper: what the columns of a table are, how its first swings would look, what the whole would bring, and it is stored
/// and undone as one step.

#include <optional>

#include "ui/intake/YearsWork.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class YearsImportPage : public Page {
    Q_OBJECT

public:
    YearsImportPage(db::Stores& stores, FileQuestions questions, QWidget* parent = nullptr);
    ~YearsImportPage() override;

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; } ///< it owns no record
    void readTable(const QString& path);

signals:
    void done(const QString& message);

private:
    enum class Doing { Nothing, Looking, Storing, Undoing };

    void build();
    QWidget* buildWhole();
    void choose();
    void fillColumns(const YearsColumnsShown& shown);
    void mappingChanged();
    void glance();
    void look();
    void store();
    void undo();
    void start(Doing doing, const QString& what, Worker<db::YearsOutcome>::Work work);
    void take(Result<db::YearsOutcome> outcome);
    void tell(const db::YearsOutcome& outcome);
    void enable();
    [[nodiscard]] YearsTable mapping() const;

    db::Stores& m_stores;
    FileQuestions m_questions;
    QString m_path;
    YearsHeader m_header;
    std::optional<db::YearsMade> m_made; ///< what the last import stored, while it can be undone
    Doing m_doing = Doing::Nothing;
    bool m_looked = false; ///< the whole table was read as it is mapped now, and nothing is wrong with it

    QPushButton *m_open, *m_store, *m_undo, *m_cancel;
    QLabel *m_file, *m_state;
    QProgressBar* m_progress;
    QTableWidget *m_columns, *m_swings;
    QComboBox *m_cells, *m_by, *m_dates, *m_stage, *m_kind;
    QLineEdit *m_type, *m_compass;
    QListWidget* m_findings;
    Worker<db::YearsOutcome> m_worker; ///< last: its work ends before anything else of the page
};

} // namespace lubberline::ui
