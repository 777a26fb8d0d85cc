#pragma once
/// Fields that write themselves to storage when they are left: the pieces of all "editable in place" forms.

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include <functional>
#include <vector>

#include "core/base/Result.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

/// Whether two states are of one record; what has no record id is always one.
template <class Record>
[[nodiscard]] bool isSameRecord(const Record& one, const Record& other)
{
    if constexpr (requires { one.record; })
        return one.record == other.record;
    else
        return true;
}

/// Lines and choices of a form, each with a way to show a record and a way to take over what was typed. A line whose text is
/// refused keeps it, with the reason as its tooltip and a red text, and changes nothing.
template <class Record>
class FormFields {
public:
    using Take = std::function<Result<void>(Record&, const QString&)>;
    using Store = std::function<void(const Record&, const QString& field)>;

    explicit FormFields(Store store) : m_store(std::move(store)) {}

    QLineEdit* addLine(QFormLayout& form, const QString& title, const QString& name, std::function<QString(const Record&)> show, Take take);
    QComboBox* addChoice(QFormLayout& form, const QString& title, const QString& name, const QStringList& words,
        std::function<int(const Record&)> show, std::function<void(Record&, int)> take);

    void show(const Record& record, bool editable);
    [[nodiscard]] const Record& record() const { return m_record; }

private:
    struct Line {
        QLineEdit* edit;
        std::function<QString(const Record&)> show;
    };
    struct Choice {
        QComboBox* box;
        std::function<int(const Record&)> show;
    };
    void takeLine(QLineEdit& edit, const Take& take, const QString& title);

    Store m_store;
    Record m_record;
    std::vector<Line> m_lines;
    std::vector<Choice> m_choices;
};

/// Marks a line whose text was refused; an empty message unmarks it.
void markRefused(QLineEdit& edit, const QString& message);
/// "&Radio:" without what is for the form only: the field's name in Undo.
[[nodiscard]] QString plainTitle(QString title);

/// A text field of a record: a take that never refuses.
template <class Record>
typename FormFields<Record>::Take takeText(std::string Record::*member)
{
    return [member](Record& record, const QString& text) {
        record.*member = text.trimmed().toStdString();
        return Result<void>();
    };
}

template <class Record>
QLineEdit* FormFields<Record>::addLine(
    QFormLayout& form, const QString& title, const QString& name, std::function<QString(const Record&)> showField, Take take)
{
    auto* edit = new QLineEdit;
    edit->setObjectName(name);
    form.addRow(title, edit);
    m_lines.push_back({edit, std::move(showField)});
    QObject::connect(
        edit, &QLineEdit::editingFinished, edit, [this, edit, take = std::move(take), title] { takeLine(*edit, take, title); });
    return edit;
}

template <class Record>
void FormFields<Record>::takeLine(QLineEdit& edit, const Take& take, const QString& title)
{
    if (edit.isReadOnly() || !edit.isModified())
        return;
    Record after = m_record;
    const auto taken = take(after, edit.text());
    markRefused(edit, taken ? QString() : translated(taken.error().message));
    if (!taken)
        return;
    edit.setModified(false);
    if (!(after == m_record))
        m_store(after, plainTitle(title));
}

template <class Record>
QComboBox* FormFields<Record>::addChoice(QFormLayout& form, const QString& title, const QString& name, const QStringList& words,
    std::function<int(const Record&)> showField, std::function<void(Record&, int)> take)
{
    auto* box = new QComboBox;
    box->setObjectName(name);
    box->addItems(words);
    form.addRow(title, box);
    m_choices.push_back({box, std::move(showField)});
    QObject::connect(box, &QComboBox::activated, box, [this, take = std::move(take), title](int choice) {
        Record after = m_record;
        take(after, choice);
        if (!(after == m_record))
            m_store(after, plainTitle(title));
    });
    return box;
}

template <class Record>
void FormFields<Record>::show(const Record& record, bool editable)
{
    const bool same = isSameRecord(m_record, record);
    m_record = record;
    for (const Line& line : m_lines) {
        line.edit->setReadOnly(!editable);
        if (same && line.edit->isModified())
            continue; // somebody is typing here, or it was refused; never of one record in the form of another
        line.edit->setText(line.show(record));
        line.edit->setCursorPosition(0);
        markRefused(*line.edit, {});
    }
    for (const Choice& choice : m_choices) {
        choice.box->setEnabled(editable);
        choice.box->setCurrentIndex(choice.show(record));
    }
}

} // namespace lubberline::ui
