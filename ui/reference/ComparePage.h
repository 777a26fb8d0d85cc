#pragma once
/// Two compasses of an aircraft read together: which of them moved.

#include "core/check/TwoCompasses.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace lubberline::db {
class Stores;
}

namespace lubberline::ui {

class ComparePage : public Page {
    Q_OBJECT

public:
    ComparePage(db::Stores& stores, FileQuestions files, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem& record) const override;
    [[nodiscard]] Shown shown() const override;

    [[nodiscard]] const std::optional<PairVerdict>& verdict() const { return m_verdict; }
    void load();
    void writeReport();
    void makeDue(); ///< an event of the aircraft, which makes a swing due until one is signed or somebody answers for not swinging

protected:
    void anglesChanged() override { judge(); }

private:
    void build();
    void chooseSecond();
    void showPairs(const std::vector<PairReading>& pairs);
    void judge();
    [[nodiscard]] Result<std::vector<PairReading>> pairs() const;
    Result<CompassBelief> beliefOfCompass(const CompassSystem& compass);

    db::Stores& m_stores;
    FileQuestions m_files;
    Aircraft m_aircraft;
    CompassSystem m_first;
    std::vector<CompassSystem> m_others;
    CompassBelief m_firstBelief, m_secondBelief;
    std::optional<PairVerdict> m_verdict;
    QComboBox* m_second;
    QTableWidget* m_table;
    QLabel *m_answer, *m_figures;
    QPushButton* m_due;
    bool m_showing = false;
};

} // namespace lubberline::ui
