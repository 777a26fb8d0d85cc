#pragma once
/// A stack that asks for the room of what is in front, and not of the largest page that it could show.

#include <QEvent>
#include <QLayout>
#include <QStackedWidget>

namespace lubberline::ui {

class FrontStack : public QStackedWidget {
public:
    explicit FrontStack(QWidget* parent = nullptr) : QStackedWidget(parent)
    {
        connect(this, &QStackedWidget::currentChanged, this, [this] {
            askForHeight();
            updateGeometry();
        });
    }
    [[nodiscard]] QSize sizeHint() const override { return currentWidget() ? currentWidget()->sizeHint() : QSize(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return currentWidget() ? currentWidget()->minimumSizeHint() : QSize(); }

protected:
    bool event(QEvent* event) override
    {
        const bool done = QStackedWidget::event(event);
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
            askForHeight();
        return done;
    }

private:
    /// A label that wraps needs the more height the narrower it is, which a splitter above does not ask for.
    void askForHeight()
    {
        const QLayout* layout = currentWidget() ? currentWidget()->layout() : nullptr;
        const int least = layout && layout->hasHeightForWidth() ? layout->totalMinimumHeightForWidth(width()) : 0;
        if (least != minimumHeight())
            setMinimumHeight(least);
    }
};

} // namespace lubberline::ui
