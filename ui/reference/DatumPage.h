#pragma once
/// A datum away from any base: the sun, a runway, a carried gyro, a synchro; headings from grid north: what each tells, and how well.

#include <array>

#include "ui/kit/FileQuestions.h"
#include "ui/kit/FormField.h"
#include "ui/kit/Page.h"
#include "ui/reference/DatumMethods.h"

class QComboBox;
class QStackedWidget;
class QTableWidget;

namespace lubberline::ui {

class DrawnPlot;

class DatumPage : public Page {
    Q_OBJECT

public:
    /// @param nowUtc ISO 8601 date and time.
    DatumPage(FileQuestions files, std::function<std::string()> nowUtc, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem&) override { return {}; }
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] Plot* plot() const override;
    [[nodiscard]] const DatumInputs& inputs() const { return m_fields.record(); }
    void writeReport();

protected:
    void anglesChanged() override { answer(); }

private:
    void build();
    void buildSun(QFormLayout& form);
    void buildGrid(QFormLayout& form);
    void addPlace(QFormLayout& form, const char* prefix);
    void addSize(QFormLayout& form, const QString& title, const char* name, std::function<double&(DatumInputs&)> member);
    void addBearing(QFormLayout& form, const QString& title, const char* name, std::optional<double> DatumInputs::*member);
    void take(const DatumInputs& inputs);
    void answer();
    [[nodiscard]] DatumMethod method() const;

    FileQuestions m_files;
    std::function<std::string()> m_nowUtc;
    FormFields<DatumInputs> m_fields;
    QComboBox* m_method;
    QStackedWidget* m_forms;
    QLabel *m_headline, *m_lines;
    QTableWidget* m_budget;
    DrawnPlot* m_day;
};

} // namespace lubberline::ui
