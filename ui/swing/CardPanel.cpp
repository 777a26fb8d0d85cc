#include "ui/swing/CardPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/angle/PrintedHeading.h"
#include "core/swing/CardRemarks.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/report/card/CardWords.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum CardColumnOfPage { Even, Figure, Residual, Band, kCardColumns };
constexpr int kCardPanelHeight_px = 210, kCardRow_px = 20, kRemarkLines = 4;

QString threeDigitsAndTenth(double heading_deg)
{
    return inAngleColumn(QStringLiteral("%1").arg(printedHeading_deg(heading_deg, 1), 5, 'f', 1, QChar('0')));
}

} // namespace

CardPanel::CardPanel(QWidget* parent)
    : QFrame(parent)
    , m_step(new QComboBox)
    , m_by(new QComboBox)
    , m_from(new QComboBox)
    , m_at(new QDoubleSpinBox)
    , m_between(new QLabel)
    , m_banner(new QLabel)
    , m_remarks(new QLabel)
    , m_table(new QTableWidget(0, kCardColumns))
    , m_write(new QPushButton(tr("&Write this card…")))
{
    build();
}

void CardPanel::build()
{
    setFrameShape(QFrame::StyledPanel);
    m_step->setObjectName(QStringLiteral("cardStep"));
    for (const int step_deg : kCardSteps_deg)
        m_step->addItem(tr("every %1°").arg(step_deg), step_deg);
    m_step->setCurrentIndex(m_step->findData(30));
    m_by->setObjectName(QStringLiteral("cardBy"));
    m_by->addItems({tr("magnetic heading: what to steer"), tr("compass heading: which magnetic")});
    m_from->setObjectName(QStringLiteral("cardFrom"));
    m_from->addItems({tr("exact fit"), tr("nearest reading")});
    m_at->setObjectName(QStringLiteral("cardAt"));
    m_at->setRange(0, 359.9);
    m_at->setDecimals(1);
    m_at->setWrapping(true);
    m_at->setSuffix(QStringLiteral("°"));
    m_between->setObjectName(QStringLiteral("cardBetween"));
    m_between->setWordWrap(true);
    m_banner->setObjectName(QStringLiteral("cardBanner"));
    m_banner->setWordWrap(true);
    m_banner->setAlignment(Qt::AlignCenter);
    QFont bold; // no style sheet: with one it would keep the colours of the theme of now
    bold.setBold(true);
    m_banner->setFont(bold);
    m_banner->hide();
    m_remarks->setObjectName(QStringLiteral("cardRemarks"));
    m_remarks->setWordWrap(true);
    m_remarks->setAlignment(Qt::AlignTop);
    m_remarks->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setObjectName(QStringLiteral("cardRows"));
    m_table->setAccessibleName(tr("Correction card"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(kCardRow_px);
    m_table->setMinimumWidth(m_table->fontMetrics().horizontalAdvance(QString(36, QChar('0'))));
    m_table->setTabKeyNavigation(false);
    m_write->setObjectName(QStringLiteral("writeThisCard"));
    m_write->setAutoDefault(true);
    auto* removed = new QHBoxLayout;
    for (const Coefficient coefficient : kCoefficients) {
        auto* box = new QCheckBox(QString(QChar::fromLatin1(letterOf(coefficient))));
        box->setObjectName(QStringLiteral("cardWithout%1").arg(letterOf(coefficient)));
        box->setToolTip(tr("Taken out mechanically after the swing: the card is then no longer what was signed"));
        connect(box, &QCheckBox::toggled, this, &CardPanel::refresh);
        m_removed[indexOf(coefficient)] = box;
        removed->addWidget(box);
    }
    auto* form = new QFormLayout;
    form->addRow(tr("Rows:"), m_step);
    form->addRow(tr("By:"), m_by);
    form->addRow(tr("From:"), m_from);
    form->addRow(tr("Without:"), removed);
    form->addRow(tr("Between rows:"), m_at);
    form->addRow(m_between);
    auto* choices = new QWidget;
    auto* left = new QVBoxLayout(choices);
    left->setContentsMargins(0, 0, 0, 0);
    left->addLayout(form);
    left->addStretch();
    left->addWidget(m_write);
    m_scroll = new QScrollArea;
    m_scroll->setWidget(m_remarks);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_choices = new SidePanel(choices);
    auto* middle = new QVBoxLayout;
    middle->addWidget(m_banner);
    middle->addWidget(m_table, 1);
    m_parts = new QGridLayout(this);
    m_parts->setContentsMargins(8, 4, 8, 4);
    m_parts->addWidget(m_choices, 0, 0);
    m_parts->addLayout(middle, 0, 1);
    m_parts->setColumnStretch(1, 3);
    m_parts->setRowStretch(0, 1);
    placeRemarks(false);
    for (QComboBox* box : {m_step, m_by, m_from})
        connect(box, &QComboBox::currentIndexChanged, this, &CardPanel::refresh);
    connect(m_at, &QDoubleSpinBox::valueChanged, this, &CardPanel::showBetween);
    connect(m_write, &QPushButton::clicked, this, [this] { emit writeCard(options()); });
}

/// At the right of the card while there is room for lines that can be read, else under everything.
void CardPanel::placeRemarks(bool beneath)
{
    m_beneath = beneath;
    m_parts->removeWidget(m_scroll);
    if (beneath)
        m_parts->addWidget(m_scroll, 1, 0, 1, 2);
    else
        m_parts->addWidget(m_scroll, 0, 2);
    m_parts->setColumnStretch(2, beneath ? 0 : 3);
    const int lines = kRemarkLines * fontMetrics().lineSpacing();
    m_scroll->setMinimumHeight(lines);
    setFixedHeight(std::max(kCardPanelHeight_px, m_choices->sizeHint().height() + 12) + (beneath ? lines + m_parts->spacing() : 0));
}

void CardPanel::resizeEvent(QResizeEvent* event)
{
    const bool beneath = width() < m_choices->sizeHint().width() + 2 * m_table->minimumWidth();
    if (beneath != m_beneath)
        placeRemarks(beneath);
    QFrame::resizeEvent(event);
}

CardOptions CardPanel::options() const
{
    CardOptions options;
    options.step_deg = m_step->currentData().toInt();
    options.by = m_by->currentIndex() == 0 ? CardBy::Magnetic : CardBy::Compass;
    options.source = m_from->currentIndex() == 0 ? CardSource::Fit : CardSource::Readings;
    for (const Coefficient coefficient : kCoefficients)
        options.removed.set(indexOf(coefficient), m_removed[indexOf(coefficient)]->isChecked());
    return options;
}

void CardPanel::show(
    const SwingRecord& record, const std::shared_ptr<const Analysis>& analysis, const QString& whyNone, bool holds, bool superseded)
{
    m_holds = holds;
    m_superseded = superseded;
    m_record = record;
    m_analysis = analysis;
    m_whyNone = whyNone;
    refresh();
}

void CardPanel::refresh()
{
    m_card.reset();
    QString why = m_whyNone;
    if (m_analysis) {
        auto card = makeCard(*m_analysis, options());
        if (card)
            m_card = std::move(card.value());
        else
            why = toText(card.error().message);
    }
    m_table->setRowCount(0);
    m_write->setEnabled(m_card.has_value());
    m_banner->setVisible(m_card.has_value());
    if (m_card)
        showCard(*m_card);
    else
        m_remarks->setText(why);
    showBetween();
}

void CardPanel::showCard(const Card& card)
{
    const bool byCompass = card.options.by == CardBy::Compass;
    m_table->setHorizontalHeaderLabels(byCompass ? QStringList{tr("COMPASS"), tr("MAGNETIC"), tr("deviation (°)"), tr("± 95 % (°)")}
                                                 : QStringList{tr("FOR"), tr("STEER"), tr("deviation (°)"), tr("± 95 % (°)")});
    const CardColumn column{{}, card, m_record, m_holds, m_superseded};
    const QString banner = cardBanner({{column}, {}});
    m_banner->setText(banner);
    m_banner->setVisible(!banner.isEmpty());
    m_table->setRowCount(static_cast<int>(card.rows.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const CardRow& here = card.rows[static_cast<std::size_t>(row)];
        const QString magnetic = threeDigits(here.magneticRounded_deg()), steer = threeDigits(here.steerRounded_deg());
        const QStringList cells{byCompass ? steer : magnetic, (byCompass ? magnetic : steer) + markOf(here, column),
            shownFigure(here.residual.degrees(), 1),
            here.band_rad ? inAngleColumn(QString::number(toDegrees(*here.band_rad), 'f', 1)) : QStringLiteral("—")};
        for (int cell = 0; cell < kCardColumns; ++cell) {
            auto* item = new QTableWidgetItem(cells[cell]);
            item->setTextAlignment(Qt::AlignCenter);
            m_table->setItem(row, cell, item);
        }
    }
    QStringList words{tr("%1. %2.").arg(qualityLine(column), largestLine(column))};
    for (const auto& remark : remarksOn(card, m_record))
        words += toText(remark);
    words += tr("* nobody read near this row, ! over the limit");
    m_remarks->setText(inAngleStyle(words.join('\n')));
}

void CardPanel::showBetween()
{
    m_between->clear();
    if (!m_card)
        return;
    const auto between = betweenRows(*m_analysis, *m_card, m_at->value());
    if (!between)
        return;
    const QString pattern = m_card->options.by == CardBy::Magnetic ? tr("STEER %1 between the rows") : tr("MAGNETIC %1 between the rows");
    QString words = pattern.arg(threeDigitsAndTenth(between->interpolated_deg));
    if (between->curve_deg)
        words += tr(", %1 by the curve").arg(threeDigitsAndTenth(*between->curve_deg));
    m_between->setText(words);
}

} // namespace lubberline::ui
