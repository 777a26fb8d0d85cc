#pragma once
/// The two columns of a page: what is asked at the left, what comes of it at the right.

#include <QHash>
#include <QScrollArea>
#include <QSplitter>

namespace lubberline::ui {

/// A column of fields: as wide as it must be for their words, scrolled where it is too high, never sideways.
class SidePanel final : public QScrollArea {
public:
    explicit SidePanel(QWidget* content, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] int wholeHeight(int width) const; ///< that nothing of it is scrolled

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

/// Beside each other, parted by a handle, and each at least as high as its words that wrap; one above the other where the page is narrower
/// than both, unless they stay.
class SideBySide final : public QSplitter {
public:
    enum class Narrow { Turns, Stays };
    explicit SideBySide(Narrow narrow = Narrow::Turns);
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] int widthBeside() const;
    void turn();
    void giveHeights(); ///< a column whose words wrap is as high as they need at its width

    Narrow m_narrow;
    bool m_turning = false;
    QHash<QWidget*, int> m_own; ///< the least heights that columns have set themselves
    QList<int> m_beside;        ///< their widths before they were put above each other
};

} // namespace lubberline::ui
