#pragma once
/// The two-minute check of a compass: the headings that tell most about it, what was read there, and whether its card holds.

#include <functional>

#include "core/check/CheckHeadings.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace lubberline::db {
class Stores;
}

namespace lubberline::ui {

class CheckPage : public Page {
    Q_OBJECT

public:
    CheckPage(db::Stores& stores, FileQuestions files, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    /// Of a compass, or of the compass of a swing.
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem& record) const override;
    [[nodiscard]] Shown shown() const override;

    [[nodiscard]] const std::optional<CheckVerdict>& verdict() const { return m_verdict; }
    void writeReport();
    [[nodiscard]] QStringList printedRow(int row) const; ///< of the report: headings as they were understood, however they were typed

signals:
    void makeSwing(const Swing& swing);

protected:
    void anglesChanged() override { judge(); }

private:
    void build();
    void choose();
    void judge();
    void store();
    [[nodiscard]] std::vector<Observation> readings();
    [[nodiscard]] CheckOptions options() const;
    [[nodiscard]] QString historyWords() const;

    db::Stores& m_stores;
    FileQuestions m_files;
    CompassSystem m_compass;
    Aircraft m_aircraft;
    CompassBelief m_belief;
    std::size_t m_swings = 0;
    std::optional<double> m_limit_deg;
    std::optional<CheckVerdict> m_verdict;
    std::vector<Observation> m_read;
    QLabel *m_history, *m_answer;
    QSpinBox* m_count;
    QDoubleSpinBox *m_tolerance, *m_error;
    QTableWidget* m_table;
    QPushButton* m_store;
    bool m_showing = false;
};

} // namespace lubberline::ui
