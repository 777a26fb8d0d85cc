#pragma once
/// What is chosen once for all. A choice holds at once; the language when the window is opened anew.

#include "ui/kit/Page.h"
#include "ui/kit/PageContext.h"
#include "ui/kit/Preferences.h"

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace lubberline::ui {

class PreferencesPage : public Page {
    Q_OBJECT

public:
    explicit PreferencesPage(PageContext& context, QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }

private:
    void buildLook(QFormLayout& form);
    void buildDefaults(QFormLayout& form);
    void buildBackups(QFormLayout& form);
    void fillDefaults();
    void showChoices();
    void chooseLanguage();
    void chooseBackupFolder();

    PageContext& m_context;
    Preferences& m_preferences;
    QComboBox *m_language, *m_angles, *m_theme, *m_site, *m_instrument;
    QSpinBox *m_textSize, *m_rampSize, *m_kept;
    QLineEdit* m_folder;
    QPushButton* m_reopen;
};

} // namespace lubberline::ui
