#pragma once
/// What a map shows: which axes, the angle that is held, what it is compared with.

#include <QWidget>

#include "ui/sensor/SensorPictures.h"

class QComboBox;
class QPushButton;

namespace lubberline::ui {

class ParameterCell;
class SensorEditor;

class MapControls : public QWidget {
    Q_OBJECT

public:
    /// `editor` must outlive it.
    explicit MapControls(const SensorEditor& editor, QWidget* parent = nullptr);

    /// Takes over axes, held angle and what the models of the editor are compared with.
    void fill(ModelView& view) const;

signals:
    void played();
    void changed();
    void exportWanted();

private:
    void chooseAxes();
    void followModels();
    [[nodiscard]] std::optional<NamedModel> other() const;

    const SensorEditor& m_editor;
    QComboBox* m_axes;
    ParameterCell* m_held;
    QComboBox* m_other;
    QComboBox* m_compared;
};

} // namespace lubberline::ui
