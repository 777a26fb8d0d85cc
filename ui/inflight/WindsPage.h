#pragma once
/// Deviation of a fleet from its wind reports: the aircraft with their errors, and of the chosen one the means over headings with the fit and
/// its band, which is by flights.

#include <memory>

#include "core/format/csv/WindCsv.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QComboBox;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class DrawnPlot;

class WindsPage : public Page {
    Q_OBJECT

public:
    /// @param now the time in words, for what is printed
    WindsPage(FileQuestions questions, std::function<QString()> now, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    [[nodiscard]] Plot* plot() const override;
    void readReports(const QString& path);
    void writeTables(); ///< asks where to: CSV to upload
    void writeReport(); ///< asks where to: PDF

private:
    void build();
    void choose();
    void start();
    void take(Result<WindFile> read);
    void fill();
    void showAircraft();
    [[nodiscard]] TableFactor factor() const;

    FileQuestions m_questions;
    std::function<QString()> m_now;
    QString m_path;
    std::shared_ptr<const WindFile> m_file;
    QPushButton *m_open, *m_cancel;
    QComboBox *m_factor, *m_sense, *m_unit;
    QTableWidget* m_table;
    QLineEdit* m_control;
    DrawnPlot *m_scatter, *m_rose;
    Worker<WindFile> m_worker;
};

} // namespace lubberline::ui
