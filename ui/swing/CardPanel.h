#pragma once
/// The correction card on the page: its rows by magnetic or compass heading in steps of 10° to 45°, how sure they are, what has to
/// be said of them, and the value between two rows.

#include <QFrame>

#include <array>
#include <memory>

#include "core/record/Fleet.h"
#include "core/swing/Card.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QTableWidget;

namespace lubberline::ui {

class SidePanel;

class CardPanel : public QFrame {
    Q_OBJECT

public:
    explicit CardPanel(QWidget* parent = nullptr);

    /// @param whyNone shown when there is no analysis.
    /// @param holds the signatures stand over what the record says now, superseded a later revision amends it.
    void show(const SwingRecord& record, const std::shared_ptr<const Analysis>& analysis, const QString& whyNone, bool holds = false,
        bool superseded = false);
    using QWidget::show;

signals:
    void writeCard(const lubberline::CardOptions& options);

private:
    void build();
    void placeRemarks(bool beneath);
    void resizeEvent(QResizeEvent* event) override;
    void refresh();
    void showCard(const Card& card);
    void showBetween();
    [[nodiscard]] CardOptions options() const;

    QComboBox *m_step, *m_by, *m_from;
    std::array<QCheckBox*, kCoefficientCount> m_removed{};
    QDoubleSpinBox* m_at;
    QLabel *m_between, *m_banner, *m_remarks;
    QTableWidget* m_table;
    SidePanel* m_choices = nullptr;
    QScrollArea* m_scroll = nullptr;
    QGridLayout* m_parts = nullptr;
    bool m_beneath = false;
    QPushButton* m_write;
    SwingRecord m_record;
    std::shared_ptr<const Analysis> m_analysis;
    QString m_whyNone;
    bool m_holds = false, m_superseded = false;
    std::optional<Card> m_card;
};

} // namespace lubberline::ui
