#pragma once
/// How near things stand to a flux gate, as a checklist: type what was measured, and read what is too near. Kept until it is cleared.

#include <QWidget>

#include "core/calibration/DipoleSource.h"

class QLabel;
class QSettings;
class QTableWidget;

namespace lubberline::ui {

class InstallationPanel : public QWidget {
    Q_OBJECT

public:
    explicit InstallationPanel(QSettings& settings, QWidget* parent = nullptr);
    ~InstallationPanel() override;
    /// In the order of installationDistances().
    [[nodiscard]] std::vector<std::optional<double>> measured_m() const;

private:
    void recall();
    void changed();
    void judgeRows();

    QSettings& m_settings;
    QLabel* m_words;
    QTableWidget* m_table;
    bool m_filling = false;
};

} // namespace lubberline::ui
