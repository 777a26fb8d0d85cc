#pragma once
/// The sensor model of a compass: its figures as sliders, the maps that follow the hand, and the coefficients with their
/// causes.

#include <QTimer>

#include "core/record/Site.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/sensor/SensorPictures.h"

class QLabel;
class QUndoStack;

namespace lubberline::ui {

class MapControls;
class SensorActions;
class SensorChooser;
class SensorEditor;
class SensorFieldForm;
class SensorForm;
class SensorMaps;
class SmithTermsPanel;

class SensorPage : public Page {
    Q_OBJECT

public:
    SensorPage(EditContext& context, QUndoStack& stack, FileQuestions files, QWidget* parent = nullptr);

    /// Its newest model, in the field of its newest swing. Errors: those of the stores; what was shown stays then.
    Result<void> showCompass(CompassId id);
    [[nodiscard]] CompassId compass() const;
    [[nodiscard]] SensorEditor& editor() { return *m_editor; }
    [[nodiscard]] SensorMaps& maps() { return *m_maps; }
    /// What the maps show; none before the page is seen, and where the field does not exist.
    [[nodiscard]] const std::optional<ModelView>& view() const { return m_view; }

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem& record) const override;
    [[nodiscard]] Shown shown() const override;
    [[nodiscard]] Plot* plot() const override;

signals:
    void benchWanted(lubberline::CompassId compass);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* buildFigures(FileQuestions files);
    QWidget* buildViews();
    void connectParts();
    Result<void> showParticulars(CompassId id);
    void showField(CompassId id);
    void followSites();
    void play(); ///< soon, and coarse
    void rest(); ///< now, and fine
    void showViews(bool coarse);
    void exportFront();

    EditContext& m_context;
    FileQuestions m_files;
    SensorEditor* m_editor;
    SensorFieldForm* m_field;
    SensorForm* m_form;
    SensorActions* m_actions = nullptr;
    MapControls* m_controls;
    SensorMaps* m_maps;
    SmithTermsPanel* m_smith;
    std::optional<LimitsProfile> m_limits;
    std::optional<ModelView> m_view;
    bool m_stale = false; ///< something changed while the page was not seen
    QTimer m_soon;        ///< gathers what sliders send
};

} // namespace lubberline::ui
