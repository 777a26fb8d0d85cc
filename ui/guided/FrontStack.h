#pragma once
/// A stack that asks for the room of what is in front, and not of the largest page that it could show.

#include <QStackedWidget>

namespace lubberline::ui {

class FrontStack : public QStackedWidget {
public:
    explicit FrontStack(QWidget* parent = nullptr) : QStackedWidget(parent)
    {
        connect(this, &QStackedWidget::currentChanged, this, [this] { updateGeometry(); });
    }
    [[nodiscard]] QSize sizeHint() const override { return currentWidget() ? currentWidget()->sizeHint() : QSize(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return currentWidget() ? currentWidget()->minimumSizeHint() : QSize(); }
};

} // namespace lubberline::ui
