#include "ui/guided/TypedFigures.h"

#include <QLineEdit>
#include <QTableWidget>
#include <QTimer>

#include <algorithm>

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kTryAgain_ms = 1000; // another program is writing

QString cellName(const QTableWidget& table, int row, int column)
{
    return QStringLiteral("%1 %2 %3").arg(table.objectName()).arg(row).arg(column);
}

/// The cells that can be typed into.
template <class Each>
void eachCell(const QWidget& form, Each each)
{
    for (auto* table : form.findChildren<QTableWidget*>())
        for (int row = 0; row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column)
                each(*table, row, column);
}

} // namespace

TypedFigures::TypedFigures(db::Stores& stores, QWidget& form, QObject* parent)
    : QObject(parent)
    , m_stores(stores)
    , m_form(form)
    , m_soon(new QTimer(this))
{
    m_soon->setSingleShot(true);
    m_soon->setInterval(0); // once for all that one key changes
    connect(m_soon, &QTimer::timeout, this, &TypedFigures::keep);
    const auto changed = [this] {
        if (!m_restoring && m_swing.valid())
            m_soon->start(0);
    };
    for (auto* line : form.findChildren<QLineEdit*>())
        if (!line->objectName().isEmpty())
            connect(line, &QLineEdit::textChanged, this, changed);
    for (auto* table : form.findChildren<QTableWidget*>())
        connect(table, &QTableWidget::cellChanged, this, changed);
}

void TypedFigures::follow(SwingId swing, std::size_t step)
{
    const bool other = swing != m_swing;
    if (!other && step != m_step) { // the step took away what was kept; what still stands in the form is of the next one
        m_kept.clear();
        m_soon->start(0);
    }
    m_swing = swing;
    m_step = step;
    if (!other)
        return;
    m_soon->stop();
    m_kept.clear();
    if (auto kept = m_stores.jobs.typed(swing)) {
        m_kept = std::move(kept.value());
        putBack(m_kept);
    } else {
        emit failed(messageOf(kept.error()));
    }
}

void TypedFigures::putBack(const std::vector<TypedText>& kept)
{
    const auto textOf = [&kept](const QString& field) {
        const auto found = std::find_if(kept.begin(), kept.end(), [&](const TypedText& one) { return toText(one.field) == field; });
        return found == kept.end() ? QString() : toText(found->text);
    };
    m_restoring = true;
    for (auto* line : m_form.findChildren<QLineEdit*>())
        if (const QString text = line->objectName().isEmpty() ? QString() : textOf(line->objectName()); !text.isEmpty())
            line->setText(text);
    eachCell(m_form, [&](QTableWidget& table, int row, int column) {
        if (const QString text = textOf(cellName(table, row, column)); !text.isEmpty() && !table.item(row, column))
            table.setItem(row, column, new QTableWidgetItem(text));
    });
    m_restoring = false;
}

std::vector<TypedText> TypedFigures::typed() const
{
    std::vector<TypedText> all;
    const auto add = [&all](const QString& field, const QString& text) {
        if (!field.isEmpty() && !text.isEmpty())
            all.push_back({field.toStdString(), text.toStdString()});
    };
    for (const auto* line : m_form.findChildren<QLineEdit*>())
        if (!line->objectName().startsWith(QStringLiteral("qt_"))) // an editor of Qt's own, of a spin box or a cell
            add(line->objectName(), line->text());
    eachCell(m_form, [&add](const QTableWidget& table, int row, int column) {
        if (const auto* item = table.item(row, column); item && (item->flags() & Qt::ItemIsEditable))
            add(cellName(table, row, column), item->text());
    });
    return all;
}

QStringList TypedFigures::figures() const
{
    QStringList all;
    for (const char* name : {"guidedDatum", "guidedAstern", "guidedCompass", "guidedAfter"})
        if (const auto* line = m_form.findChild<QLineEdit*>(QString::fromLatin1(name)); line && !line->text().isEmpty())
            all += line->text();
    return all;
}

/// What another program's writing or a full drive holds up is tried again, and the step itself tells of it; where the swing has gone on
/// elsewhere there is nothing to be kept.
void TypedFigures::keep()
{
    if (!m_swing.valid() || m_stores.readOnly())
        return;
    const std::vector<TypedText> now = typed();
    if (now == m_kept)
        return;
    if (const auto kept = m_stores.jobs.keepTyped(m_swing, m_step, now); kept)
        m_kept = now;
    else if (const auto code = kept.error().code; code == ErrorCode::Locked || code == ErrorCode::Full || code == ErrorCode::Io)
        m_soon->start(kTryAgain_ms);
}

void TypedFigures::settle()
{
    if (m_soon->isActive())
        keep();
}

void TypedFigures::forget()
{
    m_soon->stop();
    m_swing = {};
    m_kept.clear();
}

} // namespace lubberline::ui
