#include "ui/kit/fit/ControlFit.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QFormLayout>
#include <QHelpEvent>
#include <QLineEdit>
#include <QPointer>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTableView>
#include <QTimer>
#include <QToolTip>

#include <algorithm>

#include "ui/kit/fit/TableFit.h"
#include "ui/kit/keys/ControlNames.h"
#include "ui/kit/keys/FocusRing.h"

namespace lubberline::ui {

namespace {

constexpr int kMostLetters = 66, kMostHint_px = 420;

bool isCut(const QComboBox& box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const QRect text = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    return box.fontMetrics().horizontalAdvance(box.currentText()) > text.width();
}

/// What is typed in it, else what it asks for; empty: all of it is seen.
QString cutTextOf(const QLineEdit& line)
{
    const QString text = line.text().isEmpty() ? line.placeholderText() : line.text();
    const bool hidden = line.echoMode() != QLineEdit::Normal;
    return hidden || line.fontMetrics().horizontalAdvance(text) <= line.width() - 10 ? QString() : text;
}

QString withTip(const QString& text, const QWidget& widget) { return widget.toolTip().isEmpty() ? text : text + '\n' + widget.toolTip(); }

/// Says as a tip what is too long for its place.
class WholeTexts final : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() != QEvent::ToolTip)
            return false;
        const auto* help = static_cast<QHelpEvent*>(event);
        if (auto* box = qobject_cast<QComboBox*>(object); box && isCut(*box)) {
            QToolTip::showText(help->globalPos(), withTip(box->currentText(), *box), box);
            return true;
        }
        if (auto* line = qobject_cast<QLineEdit*>(object)) {
            const QString text = cutTextOf(*line);
            if (!text.isEmpty())
                QToolTip::showText(help->globalPos(), withTip(text, *line), line);
            return !text.isEmpty();
        }
        auto* view = qobject_cast<QAbstractItemView*>(object->parent());
        const QModelIndex index = view ? view->indexAt(help->pos()) : QModelIndex();
        if (!index.isValid() || !index.data(Qt::ToolTipRole).toString().isEmpty()
            || view->sizeHintForIndex(index).width() <= view->visualRect(index).width())
            return false;
        QToolTip::showText(help->globalPos(), index.data().toString(), view);
        return true;
    }
};

/// A choice is never narrower than its words. Its own least size is that of the words that it was made with: Qt keeps it whatever comes in.
class ChoiceFit final : public QObject {
public:
    explicit ChoiceFit(QComboBox& box) : QObject(&box), m_box(box)
    {
        box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
        m_soon.setSingleShot(true);
        connect(&m_soon, &QTimer::timeout, this, &ChoiceFit::fit);
        const auto soon = [this] { m_soon.start(); }; // once for all that come together
        const auto* model = box.model();
        connect(model, &QAbstractItemModel::dataChanged, this, soon);
        connect(model, &QAbstractItemModel::rowsInserted, this, soon);
        connect(model, &QAbstractItemModel::rowsRemoved, this, soon);
        connect(model, &QAbstractItemModel::modelReset, this, soon);
        box.installEventFilter(this);
        fit();
    }

    [[nodiscard]] static bool stands(const QComboBox& box)
    {
        return std::any_of(box.children().begin(), box.children().end(), [](QObject* child) { return dynamic_cast<ChoiceFit*>(child); });
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange || event->type() == QEvent::Show)
            m_soon.start();
        return false;
    }

private:
    void fit()
    {
        const int most = kMostLetters * m_box.fontMetrics().averageCharWidth() + m_box.fontMetrics().height() + 14;
        m_box.setMinimumWidth(std::min(m_box.sizeHint().width(), most));
        m_box.setMaximumWidth(most);
    }

    QComboBox& m_box;
    QTimer m_soon;
};

void fitChoice(QComboBox& box)
{
    if (!ChoiceFit::stands(box))
        new ChoiceFit(box);
}

} // namespace

void showHint(QLineEdit& line)
{
    line.setFixedWidth(std::min(line.fontMetrics().horizontalAdvance(line.placeholderText()), kMostHint_px) + 24);
}

void finishControls(QWidget& page)
{
    nameControls(page);
    ringFocusedViews(page);
    fitControls(page);
}

void fitControls(QWidget& page)
{
    static QPointer<WholeTexts> tips;
    if (!tips)
        tips = new WholeTexts(qApp);
    for (auto* form : page.findChildren<QFormLayout*>())
        if (form->rowWrapPolicy() == QFormLayout::DontWrapRows)
            form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    for (auto* box : page.findChildren<QComboBox*>())
        if (!qobject_cast<QAbstractItemView*>(box->parentWidget() ? box->parentWidget()->parentWidget() : nullptr)) {
            fitChoice(*box);
            box->installEventFilter(tips);
        }
    for (auto* line : page.findChildren<QLineEdit*>())
        line->installEventFilter(tips);
    // A table that gets other headings loses those that it had, which are views, too.
    for (auto* table : page.findChildren<QTableView*>())
        fitColumns(*table);
    for (auto* view : page.findChildren<QAbstractItemView*>())
        view->viewport()->installEventFilter(tips);
}

} // namespace lubberline::ui
