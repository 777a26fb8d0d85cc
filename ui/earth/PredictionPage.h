#pragma once
/// What a compass will read at another base: from one swing, or from its swings at several places.

#include <optional>
#include <vector>

#include "core/swing/Prediction.h"
#include "db/stores/Stores.h"
#include "ui/kit/Page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;

namespace lubberline::ui {

class AssumedIronForm;
class PredictionPlot;

class PredictionPage : public Page {
    Q_OBJECT

public:
    explicit PredictionPage(db::Stores& stores, QWidget* parent = nullptr);
    /// A line that loses the focus with its window must not tell a page that is half gone.
    ~PredictionPage() override;

    /// Errors: those of the stores; what was shown stays then.
    Result<void> showSwing(SwingId id);
    [[nodiscard]] const std::optional<Prediction>& prediction() const { return m_there; }

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] Shown shown() const override { return {m_record.aircraft.id, m_record.compass.id}; }
    [[nodiscard]] Plot* plot() const override;

protected:
    void anglesChanged() override { recompute(); }

private:
    void build();
    QWidget* buildForm();
    QWidget* buildWords();
    void loadSites();
    void takeSite(int index);
    void useSwings();
    void recompute();
    void showNothing(const QString& why);
    void showPrediction(const Prediction& there, const std::optional<Prediction>& here);
    void showKnowledge();
    [[nodiscard]] Result<MeridianField> fieldThere() const;
    [[nodiscard]] Result<Prediction> predictAt(const MeridianField& field, const AssumedIron& assumed) const;
    [[nodiscard]] Result<std::vector<SwingAtPlace>> swingsOfCompass() const;

    db::Stores& m_stores;
    std::vector<Site> m_sites; ///< those with a place
    SwingRecord m_record;
    std::optional<SwingAtPlace> m_swing;
    QString m_whyNoSwing;
    std::vector<SwingAtPlace> m_others; ///< all of the compass, where the prediction is from several
    std::optional<IronSeparation> m_separation;
    std::optional<Prediction> m_there;

    QComboBox* m_basis;
    QComboBox* m_site;
    QLineEdit* m_latitude;
    QLineEdit* m_longitude;
    QLineEdit* m_date;
    AssumedIronForm* m_assumed;
    QLabel* m_field;
    QLabel* m_verdict;
    QLabel* m_again;
    QLabel* m_warnings;
    QListWidget* m_knowledge;
    PredictionPlot* m_plot;
};

} // namespace lubberline::ui
