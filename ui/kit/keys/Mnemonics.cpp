#include "ui/kit/keys/Mnemonics.h"

#include <QAbstractButton>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>

#include <functional>
#include <vector>

namespace lubberline::ui {

namespace {

qsizetype placeOf(const QString& text)
{
    for (qsizetype i = text.indexOf(u'&'); i >= 0 && i + 1 < text.size(); i = text.indexOf(u'&', i + 2))
        if (text[i + 1] != u'&')
            return i + 1;
    return -1;
}

QString without(QString text)
{
    if (const qsizetype place = placeOf(text); place > 0)
        text.remove(place - 1, 1);
    return text;
}

/// The first letter of a word is found at once; any other will do.
QString withFreeLetter(const QString& plain, const QString& taken)
{
    const qsizetype end = plain.indexOf(u'\t') < 0 ? plain.size() : plain.indexOf(u'\t');
    for (const bool wordStart : {true, false})
        for (qsizetype i = 0; i < end; ++i) {
            const bool starts = i == 0 || plain[i - 1].isSpace();
            if (plain[i].isLetterOrNumber() && (starts || !wordStart) && !taken.contains(plain[i].toUpper()))
                return QString(plain).insert(i, u'&');
        }
    return plain;
}

/// What carries a letter on a page, and how it is changed.
struct Carrier {
    QString text;
    std::function<void(const QString&)> set;
};

/// What is seen. @param but what stands in this is left out; null: nothing
void collect(const QWidget& whole, const QWidget* but, std::vector<Carrier>& carriers)
{
    for (QWidget* widget : whole.findChildren<QWidget*>()) {
        if (!widget->isVisible() || (but && but->isAncestorOf(widget)))
            continue;
        if (auto* label = qobject_cast<QLabel*>(widget); label && label->buddy())
            carriers.push_back({label->text(), [label](const QString& text) { label->setText(text); }});
        else if (auto* button = qobject_cast<QAbstractButton*>(widget); button && !button->text().isEmpty())
            carriers.push_back({button->text(), [button](const QString& text) {
                                    const QKeySequence own = button->shortcut();
                                    const bool letter = own == QKeySequence::mnemonic(button->text());
                                    button->setText(text);
                                    if (!letter && !own.isEmpty())
                                        button->setShortcut(own); // one that is no letter stays
                                }});
        else if (auto* box = qobject_cast<QGroupBox*>(widget); box && !box->title().isEmpty())
            carriers.push_back({box->title(), [box](const QString& text) { box->setTitle(text); }});
        else if (auto* tabs = qobject_cast<QTabBar*>(widget))
            for (int tab = 0; tab < tabs->count(); ++tab)
                carriers.push_back({tabs->tabText(tab), [tabs, tab](const QString& text) { tabs->setTabText(tab, text); }});
    }
}

} // namespace

QChar mnemonicOf(const QString& text)
{
    const qsizetype place = placeOf(text);
    return place < 0 ? QChar() : text[place].toUpper();
}

QStringList distinctMnemonics(const QStringList& texts, const QString& taken)
{
    QString used = taken.toUpper();
    QStringList distinct = texts;
    std::vector<qsizetype> wanting;
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const QChar letter = mnemonicOf(texts[i]);
        if (letter.isNull())
            continue;
        if (used.contains(letter))
            wanting.push_back(i);
        else
            used += letter;
    }
    for (const qsizetype i : wanting) {
        distinct[i] = withFreeLetter(without(texts[i]), used);
        if (const QChar letter = mnemonicOf(distinct[i]); !letter.isNull())
            used += letter;
    }
    return distinct;
}

void makeMnemonicsDistinct(QMenu& menu)
{
    QStringList texts;
    QList<QAction*> actions;
    for (QAction* action : menu.actions()) {
        if (action->isSeparator() || !action->isVisible())
            continue;
        actions += action;
        texts += action->text();
        if (action->menu())
            makeMnemonicsDistinct(*action->menu());
    }
    const QStringList distinct = distinctMnemonics(texts);
    for (qsizetype i = 0; i < actions.size(); ++i)
        if (actions[i]->text() != distinct[i])
            actions[i]->setText(distinct[i]);
}

void makeMnemonicsDistinct(QWidget& page, const QWidget& window)
{
    QString taken;
    const auto take = [&taken](const QString& text) {
        if (const QChar letter = mnemonicOf(text); !letter.isNull())
            taken += letter;
    };
    for (const QMenuBar* bar : window.findChildren<QMenuBar*>())
        for (const QAction* action : bar->actions())
            take(action->text());
    std::vector<Carrier> around, carriers;
    collect(window, &page, around);
    for (const Carrier& carrier : around)
        take(carrier.text);
    collect(page, nullptr, carriers);
    QStringList texts;
    for (const Carrier& carrier : carriers)
        texts += carrier.text;
    const QStringList distinct = distinctMnemonics(texts, taken);
    for (std::size_t i = 0; i < carriers.size(); ++i)
        if (carriers[i].text != distinct[static_cast<qsizetype>(i)])
            carriers[i].set(distinct[static_cast<qsizetype>(i)]);
}

} // namespace lubberline::ui
