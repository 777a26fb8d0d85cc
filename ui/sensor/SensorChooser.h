#pragma once
/// Which of a compass's sensor models is shown: list, name, note, origin, and the buttons that make and remove one.

#include <QWidget>

#include "core/record/SensorRecord.h"
#include "ui/kit/FormField.h"

class QLabel;
class QToolButton;

namespace lubberline::ui {

class SensorEditor;

class SensorChooser : public QWidget {
    Q_OBJECT

public:
    explicit SensorChooser(SensorEditor& editor, QWidget* parent = nullptr);

private:
    QToolButton* addButton(const QString& name, const QString& text, const QString& tip, const std::function<void()>& act);
    void buildFields();
    void follow();

    SensorEditor& m_editor;
    QComboBox* m_choice;
    QWidget* m_buttons;
    QToolButton *m_new, *m_duplicate, *m_remove;
    FormFields<SensorRecord> m_fields;
    QLabel* m_origin;
};

} // namespace lubberline::ui
