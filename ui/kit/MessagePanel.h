#pragma once

#include <QWidget>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace lubberline::ui {

/// Messages in place of message boxes: one is seen, the newest failure before any news, and the others wait behind it. Escape, or its
/// cross, closes the one that is seen. The same message is not shown twice; news takes the place of older news, failures never.
class MessagePanel : public QWidget {
    Q_OBJECT

public:
    explicit MessagePanel(QWidget* parent = nullptr);

    enum class Kind { Information, Failure };
    /// How long it stays unless it is closed: until another page or record is shown, or what it was of is mended; or until it is answered.
    enum class Stay { OnThisPage, UntilClosed };
    struct Answer {
        QString text;
        std::function<void()> act;
        bool closes = true; ///< the message goes with the answer
    };
    void add(Kind kind, const QString& message, const std::vector<Answer>& answers = {}, Stay stay = Stay::OnThisPage);
    [[nodiscard]] QStringList messages() const; ///< in the order in which they came
    [[nodiscard]] QString shown() const;        ///< the one that is seen
    void clear();
    void turned(); ///< another page or record is in front
    void mended(); ///< what had failed there has been done: failures of the page go
    /// @return false: there was none
    bool closeShown();

private:
    struct Entry {
        Kind kind;
        QString text;
        std::vector<Answer> answers;
        Stay stay;
    };
    template <class Predicate>
    void removeIf(Predicate gone);
    [[nodiscard]] const Entry* front() const;
    void showFront();
    void answer(std::size_t place);

    std::vector<Entry> m_entries;
    QLabel *m_sign, *m_text, *m_more;
    QWidget* m_answers;
};

} // namespace lubberline::ui
