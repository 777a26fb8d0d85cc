#pragma once
/// What is typed and not stored as a step yet: kept in the swing's own record with every key, so that a window that dies in the middle of a
/// figure shows it again, on this machine or with a copy of the database on another. The step that is stored takes it away.

#include <QObject>
#include <QStringList>

#include <vector>

#include "db/stores/Stores.h"

class QTimer;

namespace lubberline::ui {

class TypedFigures : public QObject {
    Q_OBJECT

public:
    /// Follows the lines and table cells of `form` by their names.
    TypedFigures(db::Stores& stores, QWidget& form, QObject* parent = nullptr);

    /// From now on of this swing at this step; what was kept of another swing than the one before is put back into the form.
    void follow(SwingId swing, std::size_t step);
    [[nodiscard]] QStringList figures() const; ///< that stand in the fields of a reading and are not stored
    void settle();                             ///< what was typed since the last key is kept now: the form goes
    void forget();                             ///< the swing has ended, which takes it away

signals:
    void failed(const QString& message);

private:
    void keep();
    [[nodiscard]] std::vector<TypedText> typed() const;
    void putBack(const std::vector<TypedText>& kept);

    db::Stores& m_stores;
    QWidget& m_form;
    QTimer* m_soon;
    SwingId m_swing;
    std::size_t m_step = 0;
    std::vector<TypedText> m_kept;
    bool m_restoring = false;
};

} // namespace lubberline::ui
