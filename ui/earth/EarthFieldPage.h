#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/earth/FieldGrid.h"
#include "core/record/Site.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace lubberline::db {
class Stores;
}

namespace lubberline::ui {

class FieldValues;
class WorldFieldPlot;

/// The Earth's field at a site or any other place, on a date, by a built-in model or one from a file; and a map of the world of
/// one element with the place on it. It computes when it is shown; the map on a worker.
class EarthFieldPage : public Page {
    Q_OBJECT

public:
    /// The answer is a path; empty: cancelled.
    using ChooseFile = std::function<QString(const QString& title, const QString& filter)>;

    EarthFieldPage(db::Stores& stores, ChooseFile chooseFile, QWidget* parent = nullptr);

    /// @param label  for the map; a site of that name is chosen in the list. An empty date is today.
    void showPlace(const QString& label, const Place& place, const QString& date);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] Plot* plot() const override;

protected:
    void anglesChanged() override { recompute(); }
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* buildForm();
    void connectInputs();
    void loadSites();
    void takeSite(int index);
    void typedPlace();
    void takeModel(int index);
    void loadModel();
    void typePlace(const Place& place);
    void recompute();
    void showField(const FieldModel& model, const Result<Place>& place, double year);
    void updateMap(const FieldModel& model, double year);
    void takeMap(Result<FieldGrid> grid);
    [[nodiscard]] Result<FieldModel> chosenModel(double year) const;
    [[nodiscard]] Result<Place> readPlace();
    [[nodiscard]] FieldElement element() const;

    db::Stores& m_stores;
    ChooseFile m_chooseFile;
    std::vector<Site> m_sites;        ///< those with a place
    std::vector<FieldModel> m_loaded; ///< from files
    QString m_label;                  ///< of the place on the map; empty: its coordinates
    QComboBox* m_site;
    QLineEdit* m_latitude;
    QLineEdit* m_longitude;
    QLineEdit* m_height;
    QLineEdit* m_date;
    QComboBox* m_model;
    int m_modelBefore = 0; ///< what is chosen again when no file is
    QLabel* m_used;        ///< the model that answers, and its years
    FieldValues* m_values;
    QComboBox* m_element;
    WorldFieldPlot* m_map;

    struct Wish {
        const FieldModel::Data* model = nullptr;
        double year = 0;
        FieldElement element = FieldElement::Declination;
        bool operator==(const Wish&) const = default;
    };
    std::optional<Wish> m_wished; ///< the map shown or under way
    Worker<FieldGrid> m_worker;   ///< of the map
};

} // namespace lubberline::ui
