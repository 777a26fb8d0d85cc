#pragma once
/// Compass bases: where they are, their class and certificate, what is painted there, and how they were surveyed.

#include <functional>
#include <memory>

#include "ui/kit/EditContext.h"
#include "ui/kit/FormField.h"
#include "ui/kit/Page.h"

class QLabel;
class QListWidget;
class QPushButton;
class QUndoStack;

namespace lubberline::ui {

class PasteTable;
class SurveyDrawing;

/// As it is typed, to eight digits; empty where it is not stated.
[[nodiscard]] QString optionalFigure(std::optional<double> value);

class SitesPage : public Page {
    Q_OBJECT

public:
    /// @param today UTC.
    SitesPage(EditContext& context, QUndoStack& stack, std::function<Date()> today, QWidget* parent = nullptr);
    void reload();

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] Shown shown() const override;

private:
    void build();
    void buildForm(QFormLayout& form);
    void choose(int row);
    void showSite();
    void showFitness();
    void addSite();
    void removeSite();
    void takeModelVariation();
    void store(const Site& after, const QString& what);

    // SitesPageSurvey.cpp
    void buildSurvey();
    void showSurvey();
    void takeSurvey();
    void paste();

    [[nodiscard]] std::optional<double> variationToday() const; ///< of the model there [deg, east positive]

    EditContext& m_context;
    QUndoStack& m_stack;
    std::function<Date()> m_today;
    std::vector<Site> m_sites;
    FormFields<Site> m_fields;
    QListWidget* m_list;
    QPushButton *m_add, *m_remove;
    std::shared_ptr<bool> m_addWanted = std::make_shared<bool>(false); ///< when it is opened next
    QPushButton* m_model;
    QLabel *m_fitness, *m_lines, *m_summary;
    PasteTable* m_table;
    SurveyDrawing* m_drawing;
};

} // namespace lubberline::ui
