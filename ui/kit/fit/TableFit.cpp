#include "ui/kit/fit/TableFit.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionHeader>
#include <QTableView>
#include <QTimer>

#include <algorithm>
#include <numeric>
#include <vector>

namespace lubberline::ui {

namespace {

constexpr int kMostLines = 3, kEnoughLetters = 11, kLeastText = 15; ///< a figure with its sign and unit is never cut
constexpr int kLongestWord = 30, kRowsSeen = 64;                    ///< letters: what is longer is no word; about as many as fill a screen
constexpr const char* kOwnColumns = "ownColumns";

/// In the fewest lines that are short enough, parted at spaces.
QString inLines(const QString& text, const QFontMetrics& metrics)
{
    const QStringList words = text.split(' ', Qt::SkipEmptyParts);
    const int enough = kEnoughLetters * metrics.averageCharWidth();
    if (words.size() < 2 || text.contains('\n') || metrics.horizontalAdvance(text) <= enough)
        return text;
    int width = enough;
    for (const QString& word : words)
        width = std::max(width, metrics.horizontalAdvance(word));
    for (;; width += metrics.averageCharWidth()) {
        QStringList lines{words.front()};
        for (qsizetype i = 1; i < words.size(); ++i) {
            const QString longer = lines.back() + ' ' + words[i];
            if (metrics.horizontalAdvance(longer) <= width)
                lines.back() = longer;
            else
                lines += words[i];
        }
        if (lines.size() <= kMostLines)
            return lines.join('\n');
    }
}

class WrappingHeader final : public QHeaderView {
public:
    explicit WrappingHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) { setTextElideMode(Qt::ElideNone); }

protected:
    [[nodiscard]] QSize sectionSizeFromContents(int section) const override
    {
        QFont bold = font(); // as it is drawn when a cell of its column is chosen
        bold.setBold(true);
        const QFontMetrics metrics(bold, this);
        const QString text = model()->headerData(section, Qt::Horizontal).toString();
        return QHeaderView::sectionSizeFromContents(section) - metrics.size(0, text) + metrics.size(0, inLines(text, metrics));
    }
    void initStyleOptionForIndex(QStyleOptionHeader* option, int section) const override
    {
        QHeaderView::initStyleOptionForIndex(option, section);
        QFont bold = font();
        bold.setBold(true);
        option->text = inLines(option->text, QFontMetrics(bold, this));
    }
};

class ColumnFit final : public QObject {
public:
    explicit ColumnFit(QTableView& table) : QObject(&table), m_table(table), m_lastStretches(table.horizontalHeader()->stretchLastSection())
    {
        QHeaderView& header = *table.horizontalHeader();
        header.setStretchLastSection(false);
        header.setSectionResizeMode(QHeaderView::Interactive);
        header.setResizeContentsPrecision(kRowsSeen); // some have thousands (0 looks at all of them)
        m_soon.setSingleShot(true);
        connect(&m_soon, &QTimer::timeout, this, &ColumnFit::fit);
        m_inSight.setSingleShot(true);
        connect(&m_inSight, &QTimer::timeout, this, [this] { m_table.scrollTo(m_table.currentIndex()); });
        table.viewport()->installEventFilter(this);
        connect(table.verticalScrollBar(), &QScrollBar::valueChanged, this, &ColumnFit::fitRows);
        follow();
    }

    [[nodiscard]] static bool stands(const QTableView& table)
    {
        return std::any_of(
            table.children().begin(), table.children().end(), [](QObject* child) { return dynamic_cast<ColumnFit*>(child); });
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
            fit();
        if (event->type() == QEvent::FontChange || event->type() == QEvent::Show)
            m_soon.start(); // the header is shown, and given its style, after what it stands above
        return false;
    }

private:
    void follow()
    {
        const auto* model = m_table.model();
        const auto soon = [this] { m_soon.start(); };
        connect(model, &QAbstractItemModel::dataChanged, this, soon);
        connect(model, &QAbstractItemModel::headerDataChanged, this, soon);
        connect(model, &QAbstractItemModel::rowsInserted, this, soon);
        connect(model, &QAbstractItemModel::rowsRemoved, this, soon);
        connect(model, &QAbstractItemModel::columnsInserted, this, soon);
        connect(model, &QAbstractItemModel::columnsRemoved, this, soon);
        connect(model, &QAbstractItemModel::modelReset, this, soon);
        connect(model, &QAbstractItemModel::layoutChanged, this, soon);
    }

    void fit()
    {
        if (m_fitting || !m_table.isVisible())
            return;
        m_fitting = true;
        QHeaderView& header = *m_table.horizontalHeader();
        const auto& view = static_cast<const QAbstractItemView&>(m_table);
        std::vector<int> sections, least, wanted;
        for (int i = 0; i < header.count(); ++i) {
            if (header.isSectionHidden(i))
                continue;
            const int heading = !header.isHidden() ? header.sectionSizeHint(i) : 0, content = view.sizeHintForColumn(i) + 1;
            sections.push_back(i);
            const int words = std::max(kLeastText * m_table.fontMetrics().averageCharWidth(), longestWord(i));
            least.push_back(std::max(heading, std::min(content, words)));
            wanted.push_back(std::max(heading, content));
        }
        share(wanted, least, m_table.viewport()->width());
        for (std::size_t i = 0; i < sections.size(); ++i)
            header.resizeSection(sections[i], wanted[i]);
        if (m_table.verticalHeader()->count() > 0 && m_table.verticalHeader()->sectionResizeMode(0) == QHeaderView::ResizeToContents)
            m_table.resizeRowsToContents();
        m_fitting = false;
        fitRows();
    }

    /// Words go on beneath, but none of them is broken. @return [px] the column is to have for that, the first rows looked at
    [[nodiscard]] int longestWord(int column) const
    {
        const auto& model = *m_table.model();
        const QFontMetrics metrics = m_table.fontMetrics();
        const int margin = 2 * (m_table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &m_table) + 1);
        const int icon = m_table.style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, &m_table) + margin;
        const int spare = 2 * metrics.averageCharWidth(); // on a screen of a broken scale letters are drawn wider than they are measured
        int longest = 0;
        for (int row = 0; m_table.wordWrap() && row < std::min(model.rowCount(), kRowsSeen); ++row) {
            const QModelIndex cell = model.index(row, column);
            const int beside = margin + spare + (cell.data(Qt::DecorationRole).isValid() ? icon : 0);
            for (const QString& word : cell.data().toString().split(' ', Qt::SkipEmptyParts))
                longest = std::max(longest, metrics.horizontalAdvance(word) + beside);
        }
        return std::min(longest, kLongestWord * metrics.averageCharWidth());
    }

    /// Those that are seen are as high as the lines in them; the chosen one stays in sight.
    void fitRows()
    {
        const QHeaderView& rows = *m_table.verticalHeader();
        if (m_fitting || !m_table.wordWrap() || rows.count() == 0 || rows.sectionResizeMode(0) != QHeaderView::Interactive)
            return;
        m_fitting = true;
        const auto& view = static_cast<const QAbstractItemView&>(m_table);
        const QRect chosen = m_table.visualRect(m_table.currentIndex());
        bool grown = false;
        for (int row = std::max(0, m_table.rowAt(0)), y = 0; row < rows.count() && y < m_table.viewport()->height(); ++row) {
            const int height = std::max(rows.defaultSectionSize(), view.sizeHintForRow(row) + 1);
            if (m_table.rowHeight(row) != height) {
                m_table.setRowHeight(row, height);
                grown = true;
            }
            y += height;
        }
        m_fitting = false;
        if (grown && chosen.isValid() && m_table.viewport()->rect().intersects(chosen))
            m_inSight.start(); // after the table's own, which lays it out
    }

    void share(std::vector<int>& widths, const std::vector<int>& least, int room) const
    {
        if (widths.empty())
            return;
        int rest = room - std::accumulate(widths.begin(), widths.end(), 0);
        for (int most = *std::max_element(widths.begin(), widths.end()); rest < 0 && most > 0; --most)
            for (std::size_t i = 0; i < widths.size() && rest < 0; ++i)
                if (widths[i] > most && widths[i] > least[i]) {
                    --widths[i];
                    ++rest;
                }
        if (rest > 0 && m_lastStretches)
            widths.back() += rest;
        else if (rest > 0)
            for (std::size_t i = 0; i < widths.size(); ++i)
                widths[i] += static_cast<int>((rest * (i + 1)) / widths.size() - (rest * i) / widths.size());
    }

    QTableView& m_table;
    bool m_lastStretches, m_fitting = false;
    QTimer m_soon, m_inSight;
};

} // namespace

void wrapHeadings(QTableView& table)
{
    const QHeaderView& before = *table.horizontalHeader();
    if (dynamic_cast<const WrappingHeader*>(&before))
        return;
    auto* header = new WrappingHeader(&table);
    header->setSectionsClickable(before.sectionsClickable());
    header->setHighlightSections(before.highlightSections());
    header->setStretchLastSection(before.stretchLastSection());
    header->setDefaultAlignment(before.defaultAlignment());
    header->setVisible(!before.isHidden());
    std::vector<int> hidden;
    for (int i = 0; i < before.count(); ++i)
        if (before.isSectionHidden(i))
            hidden.push_back(i);
    table.setHorizontalHeader(header);
    for (const int section : hidden)
        header->setSectionHidden(section, true);
}

void fitColumns(QTableView& table)
{
    if (!table.model() || table.property(kOwnColumns).toBool() || ColumnFit::stands(table))
        return;
    wrapHeadings(table);
    new ColumnFit(table);
}

int heightOfRows(const QTableView& table, int rows)
{
    return rows * table.verticalHeader()->defaultSectionSize() + table.horizontalHeader()->sizeHint().height() + 2 * table.frameWidth();
}

void keepOwnColumns(QTableView& table) { table.setProperty(kOwnColumns, true); }

} // namespace lubberline::ui
