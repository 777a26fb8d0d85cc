#pragma once

#include <QWidget>

#include <functional>

class QVBoxLayout;

namespace lubberline::ui {

/// Messages that stay until they are dismissed, in place of message boxes. The same message is not shown twice; news takes the
/// place of older news, failures never.
class MessagePanel : public QWidget {
    Q_OBJECT

public:
    explicit MessagePanel(QWidget* parent = nullptr);

    enum class Kind { Information, Failure };
    void add(Kind kind, const QString& message);
    /// With a button that answers the message and dismisses it.
    void add(Kind kind, const QString& message, const QString& answer, const std::function<void()>& act);
    [[nodiscard]] QStringList messages() const;
    void clear();

private:
    QWidget* makeRow(Kind kind, const QString& message);
    void remove(QWidget* row);
    QVBoxLayout* m_rows;
};

} // namespace lubberline::ui
