#pragma once
/// One swing: its readings beside its plots, coefficients underneath, and what they mean. Everything follows every stored cell.

#include <QByteArray>

#include "core/angle/AngleText.h"
#include "core/swing/Card.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/Page.h"
#include "ui/text/AngleWords.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSplitter;
class QToolButton;
class QUndoStack;

namespace lubberline::ui {

class CoefficientsPanel;
class ExclusionPanel;
class Gathering;
class KeyChecks;
class CardPanel;
class DerivationPanel;
class PlotTabs;
class ReadingsModel;
class ReadingsTable;
class SigningPanel;
class SwingEditor;
class SwingParticulars;

struct CoefficientPlace;

class SwingPage : public Page {
    Q_OBJECT

public:
    SwingPage(EditContext& context, QUndoStack& stack, QWidget* parent = nullptr);

    /// Errors: those of SwingStore::record(); what was shown stays then.
    Result<void> showSwing(SwingId id);
    void setAngleStyle(AngleStyle style);

    /// How people have set it out: what the page of another swing takes over.
    struct Look {
        int plot = 0;
        QByteArray splitter = {};
    };
    [[nodiscard]] Look look() const;
    void setLook(const Look& look);

    [[nodiscard]] SwingEditor& editor() { return *m_editor; }
    [[nodiscard]] PlotTabs& plots() { return *m_plots; }
    [[nodiscard]] Gathering& gathering() { return *m_gathering; } ///< of what a document of it is made of
    [[nodiscard]] AngleStyle angleStyle() const { return m_style; }
    [[nodiscard]] bool rowSelected() const; ///< a reading, not the empty row
    void focusReadings();

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] bool isOf(const FleetItem& record) const override;
    [[nodiscard]] Shown shown() const override;
    [[nodiscard]] Plot* plot() const override;
    [[nodiscard]] std::vector<FleetItem> path() const override;
    [[nodiscard]] QStringList unstored() const override;
    void takeLook(const Page& before) override;

public slots:
    void insertRow(); ///< before the current one
    void deleteRows();
    void toggleExcluded();
    void acceptNominal();
    void layOut(int points);
    void toggleComplete();
    void openCard();    ///< the panel with the correction card
    void openSigning(); ///< the panel, with the cursor in it

signals:
    void openSwing(lubberline::SwingId id); ///< another one is to be shown
    void writeCard(const lubberline::CardOptions& options);
    void closed(); ///< the swing that was shown is no more

protected:
    void anglesChanged() override { setAngleStyle(shownAngles()); }

private:
    void build();
    void buildHeader();
    QWidget* buildReadings();
    QWidget* buildResults();
    void connectParts();
    void showRecord();
    void onRowChanged();
    [[nodiscard]] int currentRow() const; ///< −1: none, or the empty row

    // SwingPageResults.cpp: what the readings tell
    void showResults();
    void showComputing();
    [[nodiscard]] QString meaning() const;
    [[nodiscard]] QString computingWords(const QString& meant) const;
    void showMessageLine();
    [[nodiscard]] QString suspicion() const;
    [[nodiscard]] QString remark() const;

    // SwingPagePanels.cpp: what opens above the readings
    void showParticulars(bool visible);
    void showSigning(bool visible);
    void showCard(bool visible);
    void showCardFigures();
    void showDerivation(CoefficientPlace place);

    EditContext& m_context;
    SwingEditor* m_editor;
    ReadingsModel* m_model;
    ReadingsTable* m_table;
    PlotTabs* m_plots;
    CoefficientsPanel* m_coefficients;
    ExclusionPanel* m_exclusion;
    KeyChecks* m_keys;
    Gathering* m_gathering;
    SwingParticulars* m_particulars = nullptr; ///< made when first opened
    SigningPanel* m_signing = nullptr;         ///< likewise
    DerivationPanel* m_derivation = nullptr;   ///< likewise
    CardPanel* m_card = nullptr;               ///< likewise
    QLabel* m_state;
    QProgressBar* m_computing; ///< in front while results of a log are computed
    QLabel* m_meaning;
    QString m_meant; ///< what it said of the last results
    QLabel* m_readOnly;
    QToolButton* m_showParticulars;
    QToolButton* m_showSigning;
    QToolButton* m_showCard;
    QPushButton* m_complete;
    AngleStyle m_style = shownAngles();
};

} // namespace lubberline::ui
