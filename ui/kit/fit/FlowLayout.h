#pragma once
/// Controls in a line that goes on beneath where the page is too narrow for it.

#include <QLayout>
#include <QList>

namespace lubberline::ui {

/// What is left of a line goes to those of its items that expand.
class FlowLayout final : public QLayout {
public:
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;    ///< all in one line
    [[nodiscard]] QSize minimumSize() const override; ///< of the widest item
    void setGeometry(const QRect& rect) override;

private:
    /// @return the height that is needed.
    int arrange(const QRect& rect, bool move) const;

    QList<QLayoutItem*> m_items;
};

/// A label and what it names, which stay beside each other in a line that wraps; the label's letter leads to the control.
[[nodiscard]] QWidget* labelled(const QString& text, QWidget* control);

} // namespace lubberline::ui
