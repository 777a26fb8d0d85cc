#include "ui/swing/SwingPage.h"

#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/OpenSwings.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/swing/CardPanel.h"
#include "ui/swing/CoefficientsPanel.h"
#include "ui/swing/FieldStampPanel.h"
#include "ui/swing/Gathering.h"
#include "ui/swing/KeyChecks.h"
#include "ui/swing/PlotTabs.h"
#include "ui/swing/RecordDocuments.h"
#include "ui/swing/SigningPanel.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingParticulars.h"
#include "ui/swing/SwingWords.h"
#include "ui/swing/readings/ExclusionPanel.h"
#include "ui/swing/readings/ReadingsModel.h"
#include "ui/swing/readings/ReadingsTable.h"

namespace lubberline::ui {

constexpr int kLeastRows = 6; ///< of readings that are seen whatever panels are open: the page scrolls before

SwingPage::SwingPage(EditContext& context, QUndoStack& stack, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_editor(new SwingEditor(context, stack, this))
    , m_model(new ReadingsModel(*m_editor, this))
    , m_table(new ReadingsTable(*m_model))
    , m_plots(new PlotTabs)
    , m_coefficients(new CoefficientsPanel)
    , m_exclusion(new ExclusionPanel)
    , m_keys(new KeyChecks(context.stores, this))
    , m_gathering(new Gathering(context.stores))
    , m_state(new QLabel)
    , m_computing(new QProgressBar)
    , m_meaning(new QLabel)
    , m_readOnly(new QLabel)
    , m_showParticulars(new QToolButton)
    , m_showSigning(new QToolButton)
    , m_showCard(new QToolButton)
    , m_complete(new QPushButton)
{
    build();
    connectParts();
}

void SwingPage::build()
{
    auto* splitter = new SideBySide(SideBySide::Narrow::Stays);
    splitter->setObjectName(QStringLiteral("swingSplitter"));
    splitter->addWidget(buildReadings());
    splitter->addWidget(buildResults());
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({530, 500});
    buildHeader();
    body().addWidget(m_readOnly);
    body().addWidget(new FieldStampPanel(*m_editor));
    body().addWidget(splitter, 1);
    setTabOrder(m_showParticulars, m_showCard);
    setTabOrder(m_showCard, m_complete);
    setTabOrder(m_complete, m_showSigning);
    setTabOrder(m_showSigning, m_table);
    setFocusProxy(m_table);
}

void SwingPage::buildHeader()
{
    titleLine().setObjectName(QStringLiteral("swingTitle"));
    setTitle(tr("Swing"));
    m_state->setObjectName(QStringLiteral("swingState"));
    m_state->setFrameShape(QFrame::StyledPanel);
    m_state->setMargin(2);
    m_state->hide();
    m_showParticulars->setObjectName(QStringLiteral("showParticulars"));
    m_showParticulars->setText(tr("P&articulars"));
    m_showSigning->setObjectName(QStringLiteral("showSigning"));
    m_showSigning->setText(tr("Si&gn"));
    m_showCard->setObjectName(QStringLiteral("showCard"));
    m_showCard->setText(tr("Ca&rd"));
    for (QToolButton* opens : {m_showParticulars, m_showSigning, m_showCard}) {
        opens->setCheckable(true);
        opens->setArrowType(Qt::RightArrow);
        opens->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        opens->setFocusPolicy(Qt::StrongFocus);
    }
    m_complete->setObjectName(QStringLiteral("completeButton"));
    m_complete->hide(); // without words until there is a swing
    m_readOnly->setObjectName(QStringLiteral("readOnlyReason"));
    m_readOnly->setWordWrap(true);
    m_computing->setObjectName(QStringLiteral("computing"));
    m_computing->setFormat(tr("computing %p %"));
    m_computing->setMaximumWidth(fontMetrics().horizontalAdvance(m_computing->format()) * 2);
    m_computing->setAccessibleName(tr("Computing the results"));
    m_computing->hide();
    for (QWidget* tool :
        std::initializer_list<QWidget*>{m_gathering, m_computing, m_state, m_showParticulars, m_showCard, m_complete, m_showSigning})
        head().addWidget(tool, 0, Qt::AlignVCenter);
}

QWidget* SwingPage::buildReadings()
{
    m_table->setAccessibleName(tr("Readings"));
    messageLine().setObjectName(QStringLiteral("readingsMessage"));
    messageLine().setMinimumHeight(fontMetrics().height() + 2);
    QSizePolicy room = messageLine().sizePolicy();
    room.setRetainSizeWhenHidden(true); // the table does not jump while one types
    messageLine().setSizePolicy(room);
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    m_table->setMinimumHeight(heightOfRows(*m_table, kLeastRows));
    layout->addWidget(m_table, 1);
    layout->addWidget(&messageLine());
    layout->addWidget(m_exclusion);
    layout->addWidget(m_coefficients);
    return left;
}

QWidget* SwingPage::buildResults()
{
    auto* meaning = new QGroupBox(tr("What it means"));
    auto* meaningLayout = new QVBoxLayout(meaning);
    meaningLayout->setContentsMargins(8, 2, 8, 6);
    m_meaning->setObjectName(QStringLiteral("meaning"));
    m_meaning->setWordWrap(true);
    m_meaning->setTextInteractionFlags(Qt::TextSelectableByMouse);
    meaningLayout->addWidget(m_meaning);
    auto* right = new QWidget;
    auto* layout = new QVBoxLayout(right);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_plots, 1);
    layout->addWidget(meaning);
    return right;
}

void SwingPage::connectParts()
{
    connect(m_editor, &SwingEditor::opened, this, [this] {
        m_exclusion->hide();
        showRecord();
        m_table->goTo(0, ReadingColumn::Magnetic);
        m_table->scrollToTop();
    });
    connect(m_editor, &SwingEditor::changed, this, &SwingPage::showRecord);
    connect(m_editor, &SwingEditor::readingChanged, this, &SwingPage::showComputing);
    connect(m_editor, &SwingEditor::computed, this, &SwingPage::showRecord);
    connect(m_editor, &SwingEditor::computingProgressed, m_computing, &QProgressBar::setValue);
    connect(m_editor, &SwingEditor::closed, this, &SwingPage::closed);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &SwingPage::showMessageLine);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &SwingPage::onRowChanged);
    connect(m_plots, &PlotTabs::rowSelected, this, [this](int row) {
        m_table->goTo(row, ReadingColumn::Compass);
        m_table->setFocus();
    });
    connect(m_table, &ReadingsTable::done, this, &SwingPage::readOut);
    connect(m_table, &ReadingsTable::refused, this, &SwingPage::failed);
    connect(m_plots, &PlotTabs::readOut, this, &SwingPage::readOut);
    connect(m_plots, &PlotTabs::leaves, m_editor, &SwingEditor::settle);
    connect(m_plots, &PlotTabs::failed, this, &SwingPage::failed);
    connect(m_exclusion, &ExclusionPanel::reasonGiven, m_editor, [this](ReadingId reading, const QString& reason) {
        if (const int row = m_editor->rowOf(reading); row >= 0)
            m_editor->exclude(row, reason);
    });
    connect(m_editor, &SwingEditor::changed, m_exclusion, [this] {
        if (m_exclusion->isVisibleTo(this) && (m_editor->rowOf(m_exclusion->reading()) < 0 || !m_editor->editable()))
            m_exclusion->hide(); // it is gone
    });
    connect(m_gathering, &Gathering::failed, this, &SwingPage::failed);
    connect(m_gathering, &Gathering::cancelled, this, [this] { emit readOut(tr("Cancelled: nothing was written")); });
    connect(m_keys, &KeyChecks::checked, this, [this] {
        if (m_card && m_showCard->isChecked())
            showCardFigures();
    });
    connect(m_exclusion, &ExclusionPanel::closed, m_table, qOverload<>(&QWidget::setFocus));
    connect(m_coefficients, &CoefficientsPanel::derivationWanted, this, &SwingPage::showDerivation);
    connect(m_complete, &QPushButton::clicked, this, &SwingPage::toggleComplete);
    connect(m_showParticulars, &QToolButton::toggled, this, &SwingPage::showParticulars);
    connect(m_showSigning, &QToolButton::toggled, this, &SwingPage::showSigning);
    connect(m_showCard, &QToolButton::toggled, this, &SwingPage::showCard);
}

Result<void> SwingPage::showSwing(SwingId id)
{
    if (id == m_editor->id())
        return {};
    return m_editor->open(id);
}

SwingPage::Look SwingPage::look() const
{
    return {m_plots->currentIndex(), findChild<QSplitter*>(QStringLiteral("swingSplitter"))->saveState()};
}

void SwingPage::setLook(const Look& look)
{
    m_plots->setCurrentIndex(look.plot);
    if (!look.splitter.isEmpty())
        findChild<QSplitter*>(QStringLiteral("swingSplitter"))->restoreState(look.splitter);
}

void SwingPage::showRecord()
{
    const SwingRecord& record = m_editor->record();
    setTitle(titleOf(record) + (record.aircraft.demonstration ? tr(" · DEMONSTRATION") : QString()));
    m_state->setText(stateWords(record.swing.state, db::signedMark(m_context.stores.database(), record.swing.id, record.swing.state)));
    m_state->show();
    QStringList standing{m_editor->whyReadOnly(), abandonedWords(m_context.stores, record.swing.id)};
    standing.removeAll(QString());
    const QString why = standing.join(QStringLiteral(" "));
    m_readOnly->setText(why);
    m_readOnly->setVisible(!why.isEmpty());
    m_complete->setText(record.swing.state == SwingState::Draft ? tr("Mark &complete") : tr("Open &again…"));
    m_complete->setEnabled(m_editor->particularsEditable());
    m_complete->show();
    showResults();
    if (m_signing && m_showSigning->isChecked())
        m_signing->show(m_meaning->text());
    emit stateChanged();
}

int SwingPage::currentRow() const
{
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() && !m_model->isNewRow(current.row()) ? current.row() : -1;
}

bool SwingPage::rowSelected() const { return currentRow() >= 0; }

void SwingPage::onRowChanged()
{
    m_plots->setSelectedRow(currentRow());
    showMessageLine();
    emit stateChanged();
}

void SwingPage::setAngleStyle(AngleStyle style)
{
    if (style == m_style)
        return;
    m_style = style;
    m_model->setAngleStyle(style);
    if (m_editor->id().valid())
        showResults();
}

void SwingPage::focusReadings() { m_table->setFocus(); }

void SwingPage::insertRow()
{
    m_table->leaveCell();
    const int row = currentRow();
    if (row >= 0 && m_editor->editable() && m_editor->insertReadings(row, {Reading()}, tr("new row")))
        m_table->goTo(row, ReadingColumn::Magnetic);
}

void SwingPage::deleteRows()
{
    m_table->leaveCell();
    if (m_editor->editable())
        m_editor->removeReadings(m_table->selectedReadings());
}

void SwingPage::toggleExcluded()
{
    m_table->leaveCell();
    const int row = currentRow();
    if (row < 0 || !m_editor->editable())
        return;
    const Reading& reading = m_editor->readings()[static_cast<std::size_t>(row)];
    if (reading.exclusion)
        m_editor->exclude(row, {});
    else
        m_exclusion->ask(reading.id,
            reading.magnetic ? toText(formatHeading(reading.magnetic->degrees(), AngleStyle::DecimalDegrees, 0))
                             : tr("row %1").arg(row + 1));
}

void SwingPage::acceptNominal() { m_table->acceptNominal(); }

void SwingPage::layOut(int points)
{
    m_table->leaveCell();
    if (!m_editor->editable() || !m_editor->layOutNominals(points))
        return;
    m_table->setFocus();
    for (int row = 0; row < static_cast<int>(m_editor->readings().size()); ++row)
        if (!m_editor->readings()[static_cast<std::size_t>(row)].complete()) {
            m_table->goTo(row, ReadingColumn::Magnetic);
            return;
        }
}

} // namespace lubberline::ui
