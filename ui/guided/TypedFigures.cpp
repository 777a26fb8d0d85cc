#include "ui/guided/TypedFigures.h"

#include <QLineEdit>
#include <QTableWidget>
#include <QTimer>

namespace lubberline::ui {

namespace {

QString cellName(const QTableWidget& table, int row, int column)
{
    return QStringLiteral("%1 %2 %3").arg(table.objectName()).arg(row).arg(column);
}

} // namespace

TypedFigures::TypedFigures(QSettings& settings, QWidget& form, QObject* parent)
    : QObject(parent)
    , m_settings(settings)
    , m_form(form)
    , m_soon(new QTimer(this))
{
    m_soon->setSingleShot(true);
    m_soon->setInterval(0); // once for all that one key changes
    connect(m_soon, &QTimer::timeout, this, &TypedFigures::keep);
    const auto changed = [this] {
        if (!m_restoring && !m_record.isEmpty())
            m_soon->start();
    };
    for (auto* line : form.findChildren<QLineEdit*>())
        if (!line->objectName().isEmpty())
            connect(line, &QLineEdit::textChanged, this, changed);
    for (auto* table : form.findChildren<QTableWidget*>())
        connect(table, &QTableWidget::cellChanged, this, changed);
}

QString TypedFigures::key() const { return QStringLiteral("guided/typed/") + m_record; }

void TypedFigures::follow(const QString& record, std::size_t step)
{
    const bool other = record != m_record;
    m_record = record;
    m_step = step;
    if (!other)
        return;
    const QVariantMap kept = m_settings.value(key()).toMap();
    if (kept.value(QStringLiteral("step")).toULongLong() != step)
        return;
    m_restoring = true;
    for (auto* line : m_form.findChildren<QLineEdit*>())
        if (const auto text = kept.constFind(line->objectName()); text != kept.constEnd())
            line->setText(text->toString());
    for (auto* table : m_form.findChildren<QTableWidget*>())
        for (int row = 0; row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column)
                if (const auto text = kept.constFind(cellName(*table, row, column)); text != kept.constEnd() && !table->item(row, column))
                    table->setItem(row, column, new QTableWidgetItem(text->toString()));
    m_restoring = false;
}

void TypedFigures::keep()
{
    if (m_record.isEmpty())
        return;
    QVariantMap typed;
    for (const auto* line : m_form.findChildren<QLineEdit*>())
        if (!line->objectName().isEmpty() && !line->text().isEmpty())
            typed.insert(line->objectName(), line->text());
    for (const auto* table : m_form.findChildren<QTableWidget*>())
        for (int row = 0; row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column)
                if (const auto* item = table->item(row, column); item && (item->flags() & Qt::ItemIsEditable) && !item->text().isEmpty())
                    typed.insert(cellName(*table, row, column), item->text());
    if (typed.isEmpty()) {
        m_settings.remove(key());
    } else {
        typed.insert(QStringLiteral("step"), static_cast<qulonglong>(m_step));
        m_settings.setValue(key(), typed);
    }
    m_settings.sync(); // on disk before the next key
}

void TypedFigures::forget()
{
    if (!m_record.isEmpty())
        m_settings.remove(key());
    m_record.clear();
}

} // namespace lubberline::ui
