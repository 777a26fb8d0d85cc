#pragma once
/// What is typed and not stored as a step yet: kept with every key, so that a window that dies in the middle of a figure shows it again.
/// It belongs to one guided swing and to the step that it stood at; on any other step it is gone.

#include <QObject>
#include <QSettings>
#include <QString>

class QTimer;

namespace lubberline::ui {

class TypedFigures : public QObject {
    Q_OBJECT

public:
    /// Follows the lines and table cells of `form` by their names.
    TypedFigures(QSettings& settings, QWidget& form, QObject* parent = nullptr);

    /// From now on of this swing at this step; what was kept there is put back into the form.
    void follow(const QString& record, std::size_t step);
    void forget(); ///< the swing has ended

private:
    void keep();
    [[nodiscard]] QString key() const;

    QSettings& m_settings;
    QWidget& m_form;
    QTimer* m_soon;
    QString m_record;
    std::size_t m_step = 0;
    bool m_restoring = false;
};

} // namespace lubberline::ui
