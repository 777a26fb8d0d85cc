#include "ui/kit/keys/FocusRing.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QPlainTextEdit>
#include <QTextEdit>

#include <algorithm>

namespace lubberline::ui {

namespace {

constexpr int kWidth_px = 2;

/// Lies on the frame of its view and takes nothing from it.
class FocusRing final : public QWidget {
public:
    explicit FocusRing(QAbstractScrollArea& view) : QWidget(&view), m_view(view)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        hide();
        view.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut || event->type() == QEvent::Resize) {
            setGeometry(m_view.rect());
            setMask(QRegion(rect()) - rect().adjusted(kWidth_px, kWidth_px, -kWidth_px, -kWidth_px));
            setVisible(m_view.hasFocus());
            raise();
        }
        return false;
    }
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setPen(QPen(palette().color(QPalette::Highlight), kWidth_px, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }

private:
    QAbstractScrollArea& m_view;
};

bool isRinged(const QAbstractScrollArea& view)
{
    return std::any_of(view.children().begin(), view.children().end(), [](QObject* child) { return dynamic_cast<FocusRing*>(child); });
}

} // namespace

void ringFocusedViews(QWidget& page)
{
    for (auto* view : page.findChildren<QAbstractScrollArea*>()) {
        const QWidget* popup = view->parentWidget();
        const bool acts = (qobject_cast<QAbstractItemView*>(view) && !qobject_cast<QHeaderView*>(view)) || qobject_cast<QTextEdit*>(view)
            || qobject_cast<QPlainTextEdit*>(view);
        if (acts && !isRinged(*view) && !(popup && qobject_cast<QComboBox*>(popup->parentWidget())))
            new FocusRing(*view);
    }
}

} // namespace lubberline::ui
