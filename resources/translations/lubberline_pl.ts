<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl_PL" sourcelanguage="en">
<context>
    <name>CalibrationWords</name>
    <message>
        <source>not told</source>
        <translation>nieokreślone</translation>
    </message>
    <message>
        <source>● Good: the calibration can be used.</source>
        <translation>● Dobra: kalibracji można użyć.</translation>
    </message>
    <message>
        <source>▲ Doubtful: see why, and what to do for better.</source>
        <translation>▲ Wątpliwa: zobacz dlaczego i co zrobić, by była lepsza.</translation>
    </message>
    <message>
        <source>■ Not determined: this log does not tell the calibration.</source>
        <translation>■ Nieokreślona: z tego zapisu kalibracja nie wynika.</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Dlaczego</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Co zrobić dalej</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 samples, %2 used; unit %3 (%4).&lt;/p&gt;</source>
        <translation>&lt;p&gt;Próbki: %1, użyto %2; jednostka %3 (%4).&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Heading error (rms, largest): before %1°, %2°; after &lt;b&gt;%3°, %4°&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Błąd kursu (średni kwadratowy, największy): przed %1°, %2°; po &lt;b&gt;%3°, %4°&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;The field&apos;s size spreads by %1 before and &lt;b&gt;%2&lt;/b&gt; after (%3).&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wielkość pola rozrzuca się o %1 przed i &lt;b&gt;%2&lt;/b&gt; po (%3).&lt;/p&gt;</translation>
    </message>
    <message>
        <source>What this log cannot tell</source>
        <translation>Czego ten zapis nie określa</translation>
    </message>
    <message>
        <source>To note</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>&lt;p&gt;P, Q, R: the field of what is magnetic near the sensor (hard iron). a to k: how much the iron and the sensor&apos;s axes bend the Earth&apos;s field, 0.01 is 1 % (soft iron). F: the Earth&apos;s field.&lt;/p&gt;</source>
        <translation>&lt;p&gt;P, Q, R: pole tego, co jest namagnesowane w pobliżu czujnika (żelazo twarde). Od a do k: o ile żelazo i osie czujnika zniekształcają pole Ziemi, 0,01 to 1 % (żelazo miękkie). F: pole Ziemi.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>CompassTitle</name>
    <message>
        <source> · DEMONSTRATION</source>
        <translation> · DANE POKAZOWE</translation>
    </message>
</context>
<context>
    <name>DerivationPanel</name>
    <message>
        <source>δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′, by least squares over all readings (δ = magnetic − compass, ψ′ compass heading)</source>
        <translation>δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′, metodą najmniejszych kwadratów ze wszystkich odczytów (δ = kurs magnetyczny − kompasowy, ψ′ kurs kompasowy)</translation>
    </message>
    <message>
        <source>sin δ = 𝔄 cos δ + 𝔅 sin ψ′ + ℭ cos ψ′ + 𝔇 sin(ψ + ψ′) + 𝔈 cos(ψ + ψ′), Smith&apos;s exact equation, by least squares over all readings (ψ magnetic heading)</source>
        <translation>sin δ = 𝔄 cos δ + 𝔅 sin ψ′ + ℭ cos ψ′ + 𝔇 sin(ψ + ψ′) + 𝔈 cos(ψ + ψ′), dokładne równanie Smitha, metodą najmniejszych kwadratów ze wszystkich odczytów (ψ kurs magnetyczny)</translation>
    </message>
</context>
<context>
    <name>SlipWordsTexts</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Fleet report</source>
        <translation>Raport o flocie</translation>
    </message>
    <message>
        <source>Deviation = magnetic heading − compass heading; easterly is positive.</source>
        <translation>Dewiacja = kurs magnetyczny − kurs kompasowy; wschodnia jest dodatnia.</translation>
    </message>
</context>
<context>
    <name>app</name>
    <message>
        <source>this swing is of %1, %2; expected the aircraft and compass of %3 (%4, %5)</source>
        <translation>ten pomiar jest z %1, %2; oczekiwano statku powietrznego i busoli z %3 (%4, %5)</translation>
    </message>
    <message>
        <source>the demonstration database has no swing with a result</source>
        <translation>baza demonstracyjna nie ma pomiaru z wynikiem</translation>
    </message>
    <message>
        <source>the folder cannot be made; expected one that may be written</source>
        <translation>nie da się utworzyć folderu; oczekiwano takiego, w którym wolno pisać</translation>
    </message>
    <message>
        <source>the window could not be started</source>
        <translation>nie udało się otworzyć okna</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is no day of the calendar; expected YYYY-MM-DD</source>
        <translation>%1: &apos;%2&apos; nie jest dniem kalendarza; oczekiwano RRRR-MM-DD</translation>
    </message>
    <message>
        <source>--cause: &apos;%1&apos; is not known; expected one of %2</source>
        <translation>--cause: &apos;%1&apos; jest nieznane; oczekiwano jednego z: %2</translation>
    </message>
    <message>
        <source>--cause: &apos;%1&apos; is not known; expected one of %2 (did you mean %3?)</source>
        <translation>--cause: &apos;%1&apos; jest nieznane; oczekiwano jednego z: %2 (czy chodziło o %3?)</translation>
    </message>
    <message>
        <source>there is no event &apos;%1&apos;; expected a record id as `lubberline due` tells it</source>
        <translation>nie ma zdarzenia &apos;%1&apos;; oczekiwano identyfikatora zapisu, jaki podaje `lubberline due`</translation>
    </message>
    <message>
        <source>&apos;%1&apos; begins %2 events; expected more of the record id</source>
        <translation>od &apos;%1&apos; zaczyna się zdarzeń: %2; oczekiwano dłuższej części identyfikatora</translation>
    </message>
    <message>
        <source>an Electrical JSON</source>
        <translation>plik Electrical JSON</translation>
    </message>
    <message>
        <source>field: %1</source>
        <translation>pole: %1</translation>
    </message>
    <message>
        <source>there is no aircraft type &apos;%1&apos; with a compass; expected one of the fleet, or all</source>
        <translation>nie ma typu statku powietrznego &apos;%1&apos; z busolą; oczekiwano typu z floty albo: all</translation>
    </message>
    <message>
        <source>there is no rule &apos;%1&apos;; expected one that `lubberline rule` lists</source>
        <translation>nie ma reguły &apos;%1&apos;; oczekiwano takiej, jaką wymienia `lubberline rule`</translation>
    </message>
    <message>
        <source>--role: &apos;%1&apos; is not known; expected %2</source>
        <translation>--role: &apos;%1&apos; jest nieznane; oczekiwano %2</translation>
    </message>
    <message>
        <source>the horizontal field at the sensor vanishes on every heading, which leaves no readings for %1; expected a compass that points</source>
        <translation>pole poziome przy czujniku znika na każdym kursie, więc nie ma odczytów dla %1; oczekiwano busoli, która wskazuje</translation>
    </message>
    <message>
        <source>the horizontal field at the sensor vanishes on heading %1: no compass heading there</source>
        <translation>pole poziome przy czujniku znika na kursie %1: nie ma tam kursu kompasowego</translation>
    </message>
    <message>
        <source>--switch &quot;%1&quot;; expected NAME=on or NAME=off</source>
        <translation>--switch &quot;%1&quot;; oczekiwano NAZWA=on lub NAZWA=off</translation>
    </message>
    <message>
        <source>there is no circuit &quot;%1&quot;; the model has none</source>
        <translation>nie ma obwodu &quot;%1&quot;; model nie ma żadnego</translation>
    </message>
    <message>
        <source>there is no circuit &quot;%1&quot;; the model has %2</source>
        <translation>nie ma obwodu &quot;%1&quot;; model ma %2</translation>
    </message>
    <message>
        <source>the data folder cannot be made; name a database with --db FILE</source>
        <translation>nie da się utworzyć folderu danych; podaj bazę przez --db PLIK</translation>
    </message>
    <message>
        <source>PostgreSQL databases are not supported yet; expected an SQLite file</source>
        <translation>bazy PostgreSQL nie są jeszcze obsługiwane; oczekiwano pliku SQLite</translation>
    </message>
    <message>
        <source>swing %1 is of another compass; expected swings of one compass</source>
        <translation>pomiar %1 dotyczy innej busoli; oczekiwano pomiarów jednej busoli</translation>
    </message>
    <message>
        <source>swing %1: %2</source>
        <translation>pomiar %1: %2</translation>
    </message>
    <message>
        <source>there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set, or QT_QPA_PLATFORM names one that nobody sees); commands work without one: lubberline --help</source>
        <translation>nie ma ekranu, na którym można otworzyć okno (nie ustawiono DISPLAY ani WAYLAND_DISPLAY albo QT_QPA_PLATFORM wskazuje taki, którego nikt nie widzi); polecenia działają bez niego: lubberline --help</translation>
    </message>
    <message>
        <source>standard input (-) is named twice; expected it once, it can be read only once</source>
        <translation>wejście standardowe (-) podano dwa razy; oczekiwano raz, można je odczytać tylko jeden raz</translation>
    </message>
    <message>
        <source>a database is no stream; expected the name of an SQLite file</source>
        <translation>baza nie jest strumieniem; oczekiwano nazwy pliku SQLite</translation>
    </message>
    <message>
        <source>this is the swing of %1 once more; expected another swing of the same compass</source>
        <translation>to jeszcze raz pomiar z %1; oczekiwano innego pomiaru tej samej busoli</translation>
    </message>
    <message>
        <source>this swing is %1, that of %2 %3; expected two swings with the same adjustment</source>
        <translation>ten pomiar to %1, a ten z %2 to %3; oczekiwano dwóch pomiarów o tej samej regulacji</translation>
    </message>
    <message>
        <source>the two columns could not be told apart (both %1); expected one swing with the radio on and one with it off</source>
        <translation>nie da się odróżnić obu kolumn (obie: %1); oczekiwano jednego pomiaru z włączonym radiem i jednego z wyłączonym</translation>
    </message>
    <message>
        <source>this file is %1 once more; expected another swing of the same compass</source>
        <translation>ten plik to jeszcze raz %1; oczekiwano innego pomiaru tej samej busoli</translation>
    </message>
    <message>
        <source>neither file names its aircraft: whether both swings are of one compass is not known</source>
        <translation>żaden z plików nie podaje statku powietrznego: nie wiadomo, czy oba pomiary dotyczą jednej busoli</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no reading; expected one at least</source>
        <translation>brak odczytu; oczekiwano co najmniej jednego</translation>
    </message>
    <message>
        <source>no model is written, as none is determined: %1</source>
        <translation>nie zapisano modelu, bo żadnego nie określono: %1</translation>
    </message>
    <message>
        <source>the method attitude needs the field: --field-nT and --dip-deg, or --lat, --lon and --date</source>
        <translation>metoda attitude potrzebuje pola: --field-nT i --dip-deg albo --lat, --lon i --date</translation>
    </message>
    <message>
        <source>a swing without a date is no part of a history; expected “# date: YYYY-MM-DD”</source>
        <translation>pomiar bez daty nie należy do historii; oczekiwano „# date: RRRR-MM-DD”</translation>
    </message>
    <message>
        <source>the state of a continuous swing</source>
        <translation>stan pomiaru ciągłego</translation>
    </message>
    <message>
        <source>the state is not told yet, and not kept</source>
        <translation>stan jest jeszcze nieokreślony i nie został zachowany</translation>
    </message>
    <message>
        <source>--head: &apos;%1&apos; is no head; expected 12 to 64 hexadecimal digits</source>
        <translation>--head: &apos;%1&apos; nie jest głową łańcucha; oczekiwano od 12 do 64 cyfr szesnastkowych</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>wiersz poleceń</translation>
    </message>
    <message>
        <source>the swing %1 has no such signature; expected a signed one</source>
        <translation>pomiar %1 nie ma takiego podpisu; oczekiwano podpisanego</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos;: expected a key and what it is, as %1 date=DATUM</source>
        <translation>%1 &apos;%2&apos;: oczekiwano klucza i jego znaczenia, na przykład %1 date=DATUM</translation>
    </message>
    <message>
        <source>%1: %2 is said twice; expected it once</source>
        <translation>%1: %2 podano dwa razy; oczekiwano raz</translation>
    </message>
    <message>
        <source>a table of swings</source>
        <translation>tabela pomiarów</translation>
    </message>
    <message>
        <source>some of the files are tables of many swings, others are not; expected them in two imports</source>
        <translation>niektóre z plików są tabelami wielu pomiarów, inne nie; oczekiwano dwóch osobnych wczytań</translation>
    </message>
    <message>
        <source>an OpenPGP public key</source>
        <translation>klucz publiczny OpenPGP</translation>
    </message>
    <message>
        <source>%1 keys are in it; expected one, of one person</source>
        <translation>jest w nim kluczy: %1; oczekiwano jednego, jednej osoby</translation>
    </message>
    <message>
        <source>no leg has both a compass heading and a variation; expected compass_heading_deg and variation_deg (or --variation)</source>
        <translation>żaden odcinek nie ma zarazem kursu kompasowego i deklinacji; oczekiwano compass_heading_deg i variation_deg (albo --variation)</translation>
    </message>
    <message>
        <source>--key: the key ring has no secret key %1; expected one of `gpg --list-secret-keys`</source>
        <translation>--key: w pęku kluczy nie ma klucza tajnego %1; oczekiwano jednego z `gpg --list-secret-keys`</translation>
    </message>
    <message>
        <source>--key: several secret keys are called %1; expected its fingerprint</source>
        <translation>--key: kilka kluczy tajnych nazywa się %1; oczekiwano odcisku klucza</translation>
    </message>
    <message>
        <source>%1 of what is listed is damaged; expected a whole database: `lubberline db verify` lists all, a backup has what was</source>
        <translation>uszkodzonych pozycji na liście: %1; oczekiwano całej bazy: `lubberline db verify` wymienia wszystkie, kopia zapasowa ma to, co było</translation>
    </message>
    <message>
        <source>signed content</source>
        <translation>podpisana treść</translation>
    </message>
    <message>
        <source>a detached OpenPGP signature</source>
        <translation>odłączony podpis OpenPGP</translation>
    </message>
    <message>
        <source>the text is of a signature by name only, and this key is not its</source>
        <translation>tekst należy do podpisu samym nazwiskiem i ten klucz nie jest jego kluczem</translation>
    </message>
    <message>
        <source>standard output takes no more; expected one that is read to its end, on a drive with room</source>
        <translation>wyjście standardowe nie przyjmuje więcej; oczekiwano takiego, które jest czytane do końca, na dysku z wolnym miejscem</translation>
    </message>
    <message>
        <source>has no samples between --from and --to</source>
        <translation>nie ma próbek między --from i --to</translation>
    </message>
    <message>
        <source>there is not enough memory for this; expected smaller input or more memory</source>
        <translation>za mało pamięci; oczekiwano mniejszych danych albo większej pamięci</translation>
    </message>
    <message>
        <source>this was not foreseen (%1); please report it</source>
        <translation>tego nie przewidziano (%1); prosimy to zgłosić</translation>
    </message>
    <message>
        <source>there is no such database; expected the name of one</source>
        <translation>nie ma takiej bazy; oczekiwano nazwy istniejącej</translation>
    </message>
    <message>
        <source>the name of the file to write is not UTF-8; expected one that is</source>
        <translation>nazwa pliku do zapisania nie jest w UTF-8; oczekiwano takiej, która jest</translation>
    </message>
    <message>
        <source>the name of the database is not UTF-8; expected one that is</source>
        <translation>nazwa bazy nie jest w UTF-8; oczekiwano takiej, która jest</translation>
    </message>
    <message>
        <source>a line of sight needs the field: --field-nT and --dip-deg, or --lat, --lon and --date</source>
        <translation>linia wzroku potrzebuje pola: --field-nT i --dip-deg albo --lat, --lon i --date</translation>
    </message>
    <message>
        <source>--measured %1: expected the number of a thing, 1 to %2, and metres, 0 to 1000, as 2=1.30</source>
        <translation>--measured %1: oczekiwano numeru rzeczy, od 1 do %2, i metrów, od 0 do 1000, np. 2=1.30</translation>
    </message>
    <message>
        <source>--measured %1: that thing is named twice</source>
        <translation>--measured %1: ta rzecz jest podana dwa razy</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) in the swings (%1); expected none</source>
        <translation>
            <numerusform>%n zastrzeżenie do dewiacji (%1); oczekiwano: żadnego</numerusform>
            <numerusform>%n zastrzeżenia do dewiacji (%1); oczekiwano: żadnego</numerusform>
            <numerusform>%n zastrzeżeń do dewiacji (%1); oczekiwano: żadnego</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of the compasses of %2 are meant; expected one: state it with --compass</source>
        <translation>pasuje %1 busoli statku %2; oczekiwano jednej: podaj ją przez --compass</translation>
    </message>
    <message>
        <source>%1 benches of this compass have a record id that begins with %2; expected one</source>
        <translation>%1 pomiarów stanowiskowych tej busoli ma identyfikator zaczynający się od %2; oczekiwano jednego</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no day of the calendar; expected YYYY-MM-DD</source>
        <translation>„%1” nie jest dniem kalendarza; oczekiwano RRRR-MM-DD</translation>
    </message>
    <message>
        <source>the reading on %1° looks misread: read it again before a screw is turned</source>
        <translation>odczyt na %1° wygląda na błędny: odczytaj go ponownie, zanim ktokolwiek obróci śrubę</translation>
    </message>
    <message>
        <source>%1 is %2°, more than a corrector takes (some %3°): look for what is magnetised, or misread, before a screw is turned</source>
        <translation>%1 wynosi %2°, więcej niż usuwa kompensator (około %3°): zanim ktokolwiek obróci śrubę, sprawdź, co jest namagnesowane albo źle odczytane</translation>
    </message>
    <message>
        <source>opens no due flag</source>
        <translation>nie czyni pomiaru wymaganym</translation>
    </message>
    <message>
        <source>a swing is due until a later one is signed, or a waiver answers (%1)</source>
        <translation>pomiar jest wymagany, dopóki nie podpisze się późniejszego albo nie odpowie odstąpienie (%1)</translation>
    </message>
    <message>
        <source>is still to come: a swing is due from %1 on</source>
        <translation>dopiero nastąpi: pomiar jest wymagany od %1</translation>
    </message>
    <message>
        <source>the aircraft has no compass that it makes due</source>
        <translation>statek powietrzny nie ma busoli, dla której czyni to pomiar wymaganym</translation>
    </message>
    <message>
        <source>makes nothing due: the swing of %1 was signed after it</source>
        <translation>nie czyni pomiaru wymaganym: późniejszy pomiar z %1 podpisano</translation>
    </message>
    <message>
        <source>E is %1°, more than soft iron makes: one of the readings is likely misread, by some %2°; read them again before a screw is turned</source>
        <translation>E wynosi %1°, więcej niż daje miękkie żelazo: jeden z odczytów jest zapewne błędny, o około %2°; odczytaj je ponownie, zanim ktokolwiek obróci śrubę</translation>
    </message>
    <message>
        <source>the dip is not known: smith, simulate and map refuse this model until it or a place is stated</source>
        <translation>inklinacja nie jest znana: smith, simulate i map odmówią tego modelu, dopóki nie poda się jej albo miejsca</translation>
    </message>
    <message>
        <source>these readings are on record already: they are no part of the history here</source>
        <translation>te odczyty są już zapisane: tutaj nie należą do historii</translation>
    </message>
    <message>
        <source>what changes from here is not told: %1</source>
        <translation>co się zmienia względem tego miejsca, nie jest podane: %1</translation>
    </message>
    <message>
        <source>swing %1 is named once more; expected each swing once</source>
        <translation>pomiar %1 podano ponownie; oczekiwano każdego pomiaru raz</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>degrees such as 3.25, -3.25, 3.25W or 3°15&apos;W, between -180 and 180</source>
        <translation>stopni, na przykład 3.25, -3.25, 3.25W lub 3°15&apos;W, od -180 do 180</translation>
    </message>
    <message>
        <source>not an angle</source>
        <translation>to nie kąt</translation>
    </message>
    <message>
        <source>signed twice</source>
        <translation>znak podano dwa razy</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>za duża wartość</translation>
    </message>
    <message>
        <source>not a heading</source>
        <translation>to nie kurs</translation>
    </message>
    <message>
        <source>not a heading: it has an E or a W</source>
        <translation>to nie kurs: zawiera E lub W</translation>
    </message>
    <message>
        <source>this is a folder; expected the name of a file to write</source>
        <translation>to folder; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>this is a pipe; expected the name of a file to write</source>
        <translation>to potok; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>this is a socket; expected the name of a file to write</source>
        <translation>to gniazdo; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>this is a device; expected the name of a file to write</source>
        <translation>to urządzenie; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>this is a link that leads to no file; expected the name of a file to write</source>
        <translation>to dowiązanie, które nie prowadzi do pliku; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>the folder %1 does not exist; expected an existing folder to write into</source>
        <translation>folder %1 nie istnieje; oczekiwano istniejącego folderu do zapisu</translation>
    </message>
    <message>
        <source>%1 is not a folder; expected a folder to write into</source>
        <translation>%1 nie jest folderem; oczekiwano folderu do zapisu</translation>
    </message>
    <message>
        <source>the folder %1 takes no new file (%2); expected a folder that may be written to</source>
        <translation>folder %1 nie przyjmuje nowego pliku (%2); oczekiwano folderu, do którego wolno zapisywać</translation>
    </message>
    <message>
        <source>this is the same file as %1, which is read; expected another name</source>
        <translation>to ten sam plik co czytany %1; oczekiwano innej nazwy</translation>
    </message>
    <message>
        <source>this file may not be written (%1); expected one that may, or another name</source>
        <translation>tego pliku nie wolno zapisać (%1); oczekiwano pliku do zapisu albo innej nazwy</translation>
    </message>
    <message>
        <source>there is no room for it in the folder %1; expected a drive with free space</source>
        <translation>w folderze %1 brak na niego miejsca; oczekiwano dysku z wolnym miejscem</translation>
    </message>
    <message>
        <source>cannot be written into the folder %1 (%2); expected a drive that takes it</source>
        <translation>nie daje się zapisać w folderze %1 (%2); oczekiwano dysku, który go przyjmie</translation>
    </message>
    <message>
        <source>there is no name; expected the name of a file to write</source>
        <translation>brak nazwy; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>this is the name of a folder; expected the name of a file to write</source>
        <translation>to nazwa folderu; oczekiwano nazwy pliku do zapisania</translation>
    </message>
    <message>
        <source>is a folder; expected %1</source>
        <translation>jest folderem; oczekiwano: %1</translation>
    </message>
    <message>
        <source>cannot be opened; expected %1 that exists and may be read</source>
        <translation>nie daje się otworzyć; oczekiwano istniejącego pliku, który wolno czytać: %1</translation>
    </message>
    <message>
        <source>is larger than %1 MiB; expected %2</source>
        <translation>jest większy niż %1 MiB; oczekiwano: %2</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>nie daje się przeczytać do końca</translation>
    </message>
    <message>
        <source>no reading on %1 (within 11.25° of magnetic heading %2°); a correction needs readings on N, E, S and W</source>
        <translation>brak odczytu na %1 (w granicach 11,25° od kursu magnetycznego %2°); kompensacja wymaga odczytów na N, E, S i W</translation>
    </message>
    <message>
        <source>no readings; expected at least one for a mean</source>
        <translation>brak odczytów; do średniej oczekiwano co najmniej jednego</translation>
    </message>
    <message>
        <source>a heading or deviation is not a finite number</source>
        <translation>kurs lub dewiacja nie jest liczbą skończoną</translation>
    </message>
    <message>
        <source>no approximate coefficient %1 exists: the sine that it would have is %2; expected one between -1 and 1</source>
        <translation>współczynnik przybliżony %1 nie istnieje: jego sinus wyniósłby %2; oczekiwano wartości od -1 do 1</translation>
    </message>
    <message>
        <source>no magnetic heading gives the compass heading %1: the coefficients are too large</source>
        <translation>żaden kurs magnetyczny nie daje kursu kompasowego %1: współczynniki są za duże</translation>
    </message>
    <message>
        <source>the compass heading %1 belongs to several magnetic headings (%2): the deviation curve is folded; expected one</source>
        <translation>kursowi kompasowemu %1 odpowiada kilka kursów magnetycznych (%2): krzywa dewiacji zawija się; oczekiwano jednego</translation>
    </message>
    <message>
        <source>no compass heading gives the magnetic heading %1: the coefficients are too large</source>
        <translation>żaden kurs kompasowy nie daje kursu magnetycznego %1: współczynniki są za duże</translation>
    </message>
    <message>
        <source>the magnetic heading %1 belongs to several compass headings (%2): the deviation curve is folded; expected one</source>
        <translation>kursowi magnetycznemu %1 odpowiada kilka kursów kompasowych (%2): krzywa dewiacji zawija się; oczekiwano jednego</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>no signed swing is on record</source>
        <translation>w zapisach nie ma podpisanego pomiaru dewiacji</translation>
    </message>
    <message>
        <source>installed on %1, and no swing signed since</source>
        <translation>zabudowana %1, od tego czasu nie podpisano pomiaru dewiacji</translation>
    </message>
    <message>
        <source>the latitude is beyond the poles; expected -90 to 90 degrees, north positive</source>
        <translation>szerokość geograficzna leży poza biegunami; oczekiwano od -90 do 90 stopni, północna dodatnia</translation>
    </message>
    <message>
        <source>the longitude is not a number; expected degrees, east positive</source>
        <translation>długość geograficzna nie jest liczbą; oczekiwano stopni, wschodnia dodatnia</translation>
    </message>
    <message>
        <source>the height is outside the models; expected -10 000 to 600 000 m above the ellipsoid</source>
        <translation>wysokość wykracza poza modele; oczekiwano od -10 000 do 600 000 m nad elipsoidą</translation>
    </message>
    <message>
        <source>is no text of magnetic coefficients (WMM .COF or IGRF table)</source>
        <translation>nie jest tekstem współczynników magnetycznych (WMM .COF lub tablica IGRF)</translation>
    </message>
    <message>
        <source>is empty; expected magnetic coefficients (WMM .COF or IGRF table)</source>
        <translation>jest pusty; oczekiwano współczynników magnetycznych (WMM .COF lub tablica IGRF)</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 nie jest liczbą</translation>
    </message>
    <message>
        <source>%1 is no degree or order; expected a whole number</source>
        <translation>%1 nie jest stopniem ani rzędem; oczekiwano liczby całkowitej</translation>
    </message>
    <message>
        <source>holds degree %1 order %2 where degree %3 order %4 was expected: a line is missing, doubled or out of order</source>
        <translation>zawiera stopień %1 rząd %2 zamiast stopnia %3 rzędu %4: brakuje wiersza, jest powtórzony lub nie na miejscu</translation>
    </message>
    <message>
        <source>ends within degree %1, before order %2: it is cut short</source>
        <translation>kończy się w stopniu %1, przed rzędem %2: jest ucięty</translation>
    </message>
    <message>
        <source>has more than the six figures n m g h dg dh</source>
        <translation>ma więcej niż sześć liczb n m g h dg dh</translation>
    </message>
    <message>
        <source>gives h for order 0, where there is none</source>
        <translation>podaje h dla rzędu 0, gdzie go nie ma</translation>
    </message>
    <message>
        <source>is no header of a WMM coefficient file; expected epoch, name and date, as in &quot;2025.0 WMM-2025 11/13/2024&quot;</source>
        <translation>nie jest nagłówkiem pliku współczynników WMM; oczekiwano epoki, nazwy i daty, jak „2025.0 WMM-2025 11/13/2024”</translation>
    </message>
    <message>
        <source>has no header &quot;g/h n m 1900.0 …&quot; with its epochs; expected an IGRF table</source>
        <translation>nie ma nagłówka „g/h n m 1900.0 …” z epokami; oczekiwano tablicy IGRF</translation>
    </message>
    <message>
        <source>has epochs that are not five years apart</source>
        <translation>ma epoki, które nie są odległe o pięć lat</translation>
    </message>
    <message>
        <source>begins with %1 where %2 of degree %3 order %4 was expected: a line is missing, doubled or out of order</source>
        <translation>zaczyna się od %1 zamiast %2 stopnia %3 rzędu %4: brakuje wiersza, jest powtórzony lub nie na miejscu</translation>
    </message>
    <message>
        <source>ends within degree %1: it is cut short</source>
        <translation>kończy się w stopniu %1: jest ucięty</translation>
    </message>
    <message>
        <source>the map of the world was cancelled</source>
        <translation>anulowano mapę świata</translation>
    </message>
    <message>
        <source>%1 is valid from %2 to %3, and the date is %4</source>
        <translation>%1 obowiązuje od %2 do %3, a data to %4</translation>
    </message>
    <message>
        <source>blackout zone: H is below 2000 nT, a compass is not to be used</source>
        <translation>strefa zakazana: H poniżej 2000 nT, nie wolno używać busoli</translation>
    </message>
    <message>
        <source>caution zone: H is below 6000 nT, declination and compasses are unreliable</source>
        <translation>strefa ostrożności: H poniżej 6000 nT, deklinacja i busole są niepewne</translation>
    </message>
    <message>
        <source>%1 is no date; expected YYYY-MM-DD, or a year as 2026.5</source>
        <translation>%1 nie jest datą; oczekiwano RRRR-MM-DD albo roku jak 2026.5</translation>
    </message>
    <message>
        <source>%1 is valid from %2 to %3 and %4 from %5 to %6; the date is %7</source>
        <translation>%1 obowiązuje od %2 do %3, a %4 od %5 do %6; data to %7</translation>
    </message>
    <message>
        <source>H is %1 nT there, below 2000 nT (blackout zone): a compass tells nothing</source>
        <translation>H wynosi tam %1 nT, poniżej 2000 nT (strefa zakazana): busola niczego nie wskazuje</translation>
    </message>
    <message>
        <source>%1 is no day of the calendar; expected YYYY-MM-DD</source>
        <translation>%1 nie jest dniem kalendarza; oczekiwano RRRR-MM-DD</translation>
    </message>
    <message>
        <source>two of magnetic_heading_deg, compass_heading_deg, deviation_deg (or true_heading_deg with a line &quot;# variation_deg: …&quot; in place of the magnetic heading)</source>
        <translation>dwie z kolumn magnetic_heading_deg, compass_heading_deg, deviation_deg (albo true_heading_deg z wierszem „# variation_deg: …” zamiast kursu magnetycznego)</translation>
    </message>
    <message>
        <source>a column is missing; expected %1, found %2</source>
        <translation>brakuje kolumny; oczekiwano: %1, jest: %2</translation>
    </message>
    <message>
        <source>the column %1 is there twice; expected each column once</source>
        <translation>kolumna %1 występuje dwa razy; każdej oczekiwano raz</translation>
    </message>
    <message>
        <source>column %1 has no name; expected a name for each column</source>
        <translation>kolumna %1 nie ma nazwy; oczekiwano nazwy każdej kolumny</translation>
    </message>
    <message>
        <source>there is no header: the first row is numbers; expected a row of column names, %1</source>
        <translation>brak nagłówka: pierwszy wiersz to liczby; oczekiwano wiersza nazw kolumn, %1</translation>
    </message>
    <message>
        <source>%1: %2 is not allowed; expected %3</source>
        <translation>%1: %2 jest niedozwolone; oczekiwano: %3</translation>
    </message>
    <message>
        <source>metres from -10000 to 600000</source>
        <translation>metry od -10000 do 600000</translation>
    </message>
    <message>
        <source>the key %1 is there twice; expected each key once</source>
        <translation>klucz %1 występuje dwa razy; każdego oczekiwano raz</translation>
    </message>
    <message>
        <source>%1 is stated without %2; expected both or neither</source>
        <translation>podano %1 bez %2; oczekiwano obu albo żadnego</translation>
    </message>
    <message>
        <source>the place of the swing is stated, but no date, so the field there is not known; expected a line &quot;# date: YYYY-MM-DD&quot;</source>
        <translation>podano miejsce pomiaru, lecz nie datę, więc pole tam nie jest znane; oczekiwano wiersza „# date: RRRR-MM-DD”</translation>
    </message>
    <message>
        <source>the Earth&apos;s field at the swing&apos;s place is not known: %1</source>
        <translation>pole Ziemi w miejscu pomiaru nie jest znane: %1</translation>
    </message>
    <message>
        <source>expected a Swing CSV: text in UTF-8 with a header of named columns and one reading a row</source>
        <translation>oczekiwano pliku CSV pomiaru: tekstu UTF-8 z nagłówkiem nazw kolumn i jednym odczytem w wierszu</translation>
    </message>
    <message>
        <source>is binary: it has NUL bytes or lines of more than 1 MiB; %1</source>
        <translation>jest binarny: zawiera bajty NUL lub wiersze dłuższe niż 1 MiB; %1</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>odczyt anulowano</translation>
    </message>
    <message>
        <source>variation_deg stands below the header; expected it above, since the rows are computed with it</source>
        <translation>variation_deg stoi pod nagłówkiem; oczekiwano go powyżej, bo służy do obliczania wierszy</translation>
    </message>
    <message>
        <source>a quoted cell that begins in this row is not closed; expected a second &quot;</source>
        <translation>komórka w cudzysłowie, która zaczyna się w tym wierszu, nie jest zamknięta; oczekiwano drugiego &quot;</translation>
    </message>
    <message>
        <source>there is text behind a closing quote; expected a separator there, or &quot;&quot; for a quote inside</source>
        <translation>za zamykającym cudzysłowem stoi tekst; oczekiwano tam separatora albo &quot;&quot; dla cudzysłowu wewnątrz</translation>
    </message>
    <message>
        <source>true_heading_deg stands in place of the magnetic heading, but the variation is not stated; expected a line &quot;# variation_deg: …&quot; (degrees, east positive) above the header</source>
        <translation>zamiast kursu magnetycznego stoi true_heading_deg, lecz nie podano deklinacji; oczekiwano wiersza „# variation_deg: …” (stopnie, wschodnie dodatnie) nad nagłówkiem</translation>
    </message>
    <message>
        <source>the column %1 means nothing here; it is kept with the readings</source>
        <translation>kolumna %1 nic tu nie znaczy; jest zachowana przy odczytach</translation>
    </message>
    <message>
        <source>there are more than %1 readings; expected a compass swing</source>
        <translation>odczytów jest więcej niż %1; oczekiwano pomiaru dewiacji busoli</translation>
    </message>
    <message>
        <source>is empty; %1</source>
        <translation>jest pusty; %1</translation>
    </message>
    <message>
        <source>has no header; %1</source>
        <translation>nie ma nagłówka; %1</translation>
    </message>
    <message>
        <source>has a header but no readings; expected one reading a row below it</source>
        <translation>ma nagłówek, lecz nie ma odczytów; oczekiwano pod nim jednego odczytu w wierszu</translation>
    </message>
    <message>
        <source>%1 %2 contradicts the row&apos;s other columns, which give %3; expected %4</source>
        <translation>%1 %2 jest sprzeczne z innymi kolumnami wiersza, które dają %3; oczekiwano: %4</translation>
    </message>
    <message>
        <source>magnetic - compass, in agreement to %1 degrees</source>
        <translation>kurs magnetyczny - kompasowy, zgodnie do %1 stopnia</translation>
    </message>
    <message>
        <source>compass - magnetic, in agreement to %1 degrees</source>
        <translation>kurs kompasowy - magnetyczny, zgodnie do %1 stopnia</translation>
    </message>
    <message>
        <source>magnetic + variation, in agreement to %1 degrees</source>
        <translation>kurs magnetyczny + deklinacja, zgodnie do %1 stopnia</translation>
    </message>
    <message>
        <source>the aircraft is not named; expected a line &quot;# aircraft: REGISTRATION&quot;, or its registration beside the file</source>
        <translation>nie podano statku powietrznego; oczekiwano wiersza „# aircraft: ZNAKI” albo znaków rejestracyjnych obok pliku</translation>
    </message>
    <message>
        <source>a Bench JSON (parts and wires round a sensor)</source>
        <translation>plik Bench JSON (części i przewody wokół czujnika)</translation>
    </message>
    <message>
        <source>[x, y, z]</source>
        <translation>[x, y, z]</translation>
    </message>
    <message>
        <source>box, cylinder, ellipsoid or sphere</source>
        <translation>prostopadłościan, walec, elipsoida lub kula</translation>
    </message>
    <message>
        <source>is “%1”; expected box, cylinder, ellipsoid or sphere</source>
        <translation>jest „%1”; oczekiwano: box, cylinder, ellipsoid lub sphere</translation>
    </message>
    <message>
        <source>[[x, y, z], [x, y, z], …]</source>
        <translation>[[x, y, z], [x, y, z], …]</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true lub false</translation>
    </message>
    <message>
        <source>loop or wire</source>
        <translation>pętla lub przewód</translation>
    </message>
    <message>
        <source>is “%1”; expected loop or wire</source>
        <translation>jest „%1”; oczekiwano: loop lub wire</translation>
    </message>
    <message>
        <source>are more than 360; expected the headings of an electrical swing</source>
        <translation>jest ich więcej niż 360; oczekiwano kursów pomiaru elektrycznego</translation>
    </message>
    <message>
        <source>holds a selected heading other than 0, 90, 180 and 270</source>
        <translation>zawiera wybrany kurs inny niż 0, 90, 180 i 270</translation>
    </message>
    <message>
        <source>holds a selected heading twice; expected each once</source>
        <translation>zawiera wybrany kurs dwa razy; każdego oczekiwano raz</translation>
    </message>
    <message>
        <source>an electrical swing</source>
        <translation>pomiar elektryczny</translation>
    </message>
    <message>
        <source>%1 is there twice; expected each group once</source>
        <translation>%1 występuje dwa razy; każdej grupy oczekiwano raz</translation>
    </message>
    <message>
        <source>a day of the calendar as YYYY-MM-DD</source>
        <translation>dzień kalendarza jak RRRR-MM-DD</translation>
    </message>
    <message>
        <source>is empty; expected a day of the calendar as YYYY-MM-DD</source>
        <translation>jest puste; oczekiwano dnia kalendarza jak RRRR-MM-DD</translation>
    </message>
    <message>
        <source>a sensor model as in a Model JSON, without its field</source>
        <translation>model czujnika jak w pliku Model JSON, bez pola</translation>
    </message>
    <message>
        <source>is not &quot;lubberline&quot;; expected an exchange file (.lubberline.json)</source>
        <translation>to nie „lubberline”; oczekiwano pliku wymiany (.lubberline.json)</translation>
    </message>
    <message>
        <source>%1 is the identity of another record, too; expected one of its own</source>
        <translation>%1 to także identyfikator innego zapisu; oczekiwano własnego</translation>
    </message>
    <message>
        <source>refers to a record that is not there; expected %1 of this file</source>
        <translation>wskazuje zapis, którego nie ma; oczekiwano: %1 z tego pliku</translation>
    </message>
    <message>
        <source>the file is of exchange version %1, written by a newer Lubberline; expected versions up to %2, which this one reads</source>
        <translation>plik ma wersję wymiany %1 i pochodzi z nowszego programu Lubberline; ten czyta wersje do %2</translation>
    </message>
    <message>
        <source>the record id of a type of this file</source>
        <translation>identyfikator typu z tego pliku</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>typ</translation>
    </message>
    <message>
        <source>a site</source>
        <translation>miejsce</translation>
    </message>
    <message>
        <source>a limits profile</source>
        <translation>zestaw wartości dopuszczalnych</translation>
    </message>
    <message>
        <source>a record id</source>
        <translation>identyfikator zapisu</translation>
    </message>
    <message>
        <source>%1 is the name of another sensor model of this compass; expected one of its own</source>
        <translation>%1 to nazwa innego modelu czujnika tej busoli; oczekiwano własnej</translation>
    </message>
    <message>
        <source>are more than %1; expected a compass swing</source>
        <translation>jest ich więcej niż %1; oczekiwano pomiaru dewiacji busoli</translation>
    </message>
    <message>
        <source>the instrument&apos;s name</source>
        <translation>nazwa przyrządu</translation>
    </message>
    <message>
        <source>refers to a record that is not there; expected a type of this file</source>
        <translation>wskazuje zapis, którego nie ma; oczekiwano typu z tego pliku</translation>
    </message>
    <message>
        <source>%1 is not known; expected a cause such as lightning, engine_change or parts_replaced</source>
        <translation>%1 jest nieznane; oczekiwano przyczyny, na przykład lightning, engine_change lub parts_replaced</translation>
    </message>
    <message>
        <source>an exchange file (.lubberline.json)</source>
        <translation>plik wymiany (.lubberline.json)</translation>
    </message>
    <message>
        <source>a guided swing</source>
        <translation>pomiar prowadzony</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;; expected one of %2</source>
        <translation>ma wartość „%1”; oczekiwano jednej z: %2</translation>
    </message>
    <message>
        <source>holds what is no text</source>
        <translation>zawiera coś, co nie jest tekstem</translation>
    </message>
    <message>
        <source>is %1; expected 8, 12 or 24</source>
        <translation>wynosi %1; oczekiwano 8, 12 lub 24</translation>
    </message>
    <message>
        <source>a reading</source>
        <translation>odczyt</translation>
    </message>
    <message>
        <source>a line of the recovery file</source>
        <translation>wiersz pliku odzyskiwania</translation>
    </message>
    <message>
        <source>a Model JSON (a sensor on an aircraft)</source>
        <translation>plik Model JSON (czujnik na statku powietrznym)</translation>
    </message>
    <message>
        <source>text</source>
        <translation>tekst</translation>
    </message>
    <message>
        <source>[S, T, V]</source>
        <translation>[S, T, V]</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>liczba</translation>
    </message>
    <message>
        <source>a date as YYYY-MM-DD, or a decimal year as text</source>
        <translation>data jak RRRR-MM-DD albo rok dziesiętny jako tekst</translation>
    </message>
    <message>
        <source>says again what Z_nT says; expected one of them</source>
        <translation>powtarza to, co podaje Z_nT; oczekiwano jednego z nich</translation>
    </message>
    <message>
        <source>is that of a magnetic pole, where H is 0 and the dip does not tell the field; expected H_nT with Z_nT</source>
        <translation>to pole bieguna magnetycznego, gdzie H wynosi 0 i inklinacja nie określa pola; oczekiwano H_nT i Z_nT</translation>
    </message>
    <message>
        <source>{H_nT, dip_deg} or {lat_deg, lon_deg, alt_m, date}</source>
        <translation>{H_nT, dip_deg} lub {lat_deg, lon_deg, alt_m, date}</translation>
    </message>
    <message>
        <source>%1 is not allowed; expected %2</source>
        <translation>%1 jest niedozwolone; oczekiwano: %2</translation>
    </message>
    <message>
        <source>what is stored does not read; expected %1</source>
        <translation>zapisana treść nie daje się odczytać; oczekiwano: %1</translation>
    </message>
    <message>
        <source>pairs of texts</source>
        <translation>pary tekstów</translation>
    </message>
    <message>
        <source>three lists of figures</source>
        <translation>trzy listy liczb</translation>
    </message>
    <message>
        <source>an object of texts</source>
        <translation>obiekt z tekstami</translation>
    </message>
    <message>
        <source>the survey of a compass base</source>
        <translation>pomiar kręgu dewiacyjnego</translation>
    </message>
    <message>
        <source>holds what is no heading; expected numbers from -360 to 360</source>
        <translation>zawiera coś, co nie jest kursem; oczekiwano liczb od -360 do 360</translation>
    </message>
    <message>
        <source>is no SHA-256; expected 64 hexadecimal digits</source>
        <translation>to nie SHA-256; oczekiwano 64 cyfr szesnastkowych</translation>
    </message>
    <message>
        <source>are more than 64; expected a signed swing</source>
        <translation>jest ich więcej niż 64; oczekiwano podpisanego pomiaru</translation>
    </message>
    <message>
        <source>%1: is nested too deeply; expected %2</source>
        <translation>%1: zbyt głębokie zagnieżdżenie; oczekiwano: %2</translation>
    </message>
    <message>
        <source>%1: is there twice; expected each key once</source>
        <translation>%1: występuje dwa razy; każdego klucza oczekiwano raz</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>plik</translation>
    </message>
    <message>
        <source>is not well-formed JSON at column %1; expected %2, whole</source>
        <translation>to niepoprawny JSON w kolumnie %1; oczekiwano całości: %2</translation>
    </message>
    <message>
        <source>is empty; expected %1</source>
        <translation>jest puste; oczekiwano: %1</translation>
    </message>
    <message>
        <source>%1: is out of range; expected a number that can be held</source>
        <translation>%1: poza zakresem; oczekiwano liczby, którą da się przechować</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>liczba od %1 do %2</translation>
    </message>
    <message>
        <source>a number from %1 up</source>
        <translation>liczba od %1 wzwyż</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>has a value of the wrong kind; expected %1</source>
        <translation>ma wartość niewłaściwego rodzaju; oczekiwano: %1</translation>
    </message>
    <message>
        <source>%1 is out of range; expected %2</source>
        <translation>%1 wykracza poza zakres; oczekiwano: %2</translation>
    </message>
    <message>
        <source>is not an array of %1; expected %2 numbers in brackets</source>
        <translation>nie jest tablicą o długości %1; oczekiwano %2 liczb w nawiasach</translation>
    </message>
    <message>
        <source>is not an object; expected {…}</source>
        <translation>nie jest obiektem; oczekiwano {…}</translation>
    </message>
    <message>
        <source>%1 is not a date; expected a day of the calendar as YYYY-MM-DD</source>
        <translation>%1 nie jest datą; oczekiwano dnia kalendarza jak RRRR-MM-DD</translation>
    </message>
    <message>
        <source>%1 is not a record id; expected a UUID in lower case with hyphens</source>
        <translation>%1 nie jest identyfikatorem zapisu; oczekiwano UUID małymi literami z łącznikami</translation>
    </message>
    <message>
        <source>%1 is not whole; expected a whole number</source>
        <translation>%1 nie jest liczbą całkowitą; takiej oczekiwano</translation>
    </message>
    <message>
        <source>is not an array of %1 rows; expected %2 rows of %3 numbers in brackets</source>
        <translation>nie jest tablicą %1 wierszy; oczekiwano %2 wierszy po %3 liczb w nawiasach</translation>
    </message>
    <message>
        <source>is not known; did you mean &quot;%1&quot;?</source>
        <translation>jest nieznane; czy chodziło o „%1”?</translation>
    </message>
    <message>
        <source>is not known; expected only %1</source>
        <translation>jest nieznane; oczekiwano tylko: %1</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>tablica</translation>
    </message>
    <message>
        <source>is missing; expected %1</source>
        <translation>brakuje; oczekiwano: %1</translation>
    </message>
    <message>
        <source>has no group; expected one placement without a state</source>
        <translation>nie ma grupy; oczekiwano jednego położenia bez stanu</translation>
    </message>
    <message>
        <source>its centre must be within 1000 m of the datum</source>
        <translation>środek musi leżeć w granicach 1000 m od punktu odniesienia</translation>
    </message>
    <message>
        <source>its roll, pitch and yaw must be finite</source>
        <translation>przechylenie, pochylenie i odchylenie muszą być skończone</translation>
    </message>
    <message>
        <source>each placement in the group “%1” names its state</source>
        <translation>każde położenie w grupie „%1” podaje swój stan</translation>
    </message>
    <message>
        <source>the state “%1” is there twice</source>
        <translation>stan „%1” występuje dwa razy</translation>
    </message>
    <message>
        <source>the loop&apos;s centre must be within 1000 m of the datum</source>
        <translation>środek pętli musi leżeć w granicach 1000 m od punktu odniesienia</translation>
    </message>
    <message>
        <source>the loop&apos;s normal has no direction</source>
        <translation>normalna pętli nie ma kierunku</translation>
    </message>
    <message>
        <source>the loop&apos;s diameter must be above 0 m and at most 1000 m</source>
        <translation>średnica pętli musi być większa od 0 m i nie większa niż 1000 m</translation>
    </message>
    <message>
        <source>a loop has one turn or more</source>
        <translation>pętla ma co najmniej jeden zwój</translation>
    </message>
    <message>
        <source>a wire goes through two points or more</source>
        <translation>przewód przechodzi przez co najmniej dwa punkty</translation>
    </message>
    <message>
        <source>the points of a wire must be within 1000 m of the datum</source>
        <translation>punkty przewodu muszą leżeć w granicach 1000 m od punktu odniesienia</translation>
    </message>
    <message>
        <source>state %1=%2</source>
        <translation>stan %1=%2</translation>
    </message>
    <message>
        <source>there is no such group; expected %1</source>
        <translation>nie ma takiej grupy; oczekiwano %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>there is no such state; expected %1</source>
        <translation>nie ma takiego stanu; oczekiwano %1</translation>
    </message>
    <message>
        <source>part “%1”</source>
        <translation>część „%1”</translation>
    </message>
    <message>
        <source>a part</source>
        <translation>część</translation>
    </message>
    <message>
        <source>has no name</source>
        <translation>nie ma nazwy</translation>
    </message>
    <message>
        <source>its sizes must be above 0 m and at most 1000 m</source>
        <translation>wymiary muszą być większe od 0 m i nie większe niż 1000 m</translation>
    </message>
    <message>
        <source>it is more than 10,000 times as long as it is thick</source>
        <translation>jest ponad 10 000 razy dłuższa niż gruba</translation>
    </message>
    <message>
        <source>its susceptibility must be 0 or more (SI)</source>
        <translation>podatność musi wynosić co najmniej 0 (SI)</translation>
    </message>
    <message>
        <source>its remanence must be at most 10 T</source>
        <translation>remanencja może wynosić najwyżej 10 T</translation>
    </message>
    <message>
        <source>it is nowhere; expected a placement</source>
        <translation>nie ma położenia; oczekiwano położenia</translation>
    </message>
    <message>
        <source>circuit “%1”</source>
        <translation>obwód „%1”</translation>
    </message>
    <message>
        <source>a circuit</source>
        <translation>obwód</translation>
    </message>
    <message>
        <source>has no loop and no wire</source>
        <translation>nie ma pętli ani przewodu</translation>
    </message>
    <message>
        <source>its current must be at most 1,000,000 A</source>
        <translation>prąd może wynosić najwyżej 1 000 000 A</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>czujnik</translation>
    </message>
    <message>
        <source>it must be within 1000 m of the datum</source>
        <translation>musi leżeć w granicach 1000 m od punktu odniesienia</translation>
    </message>
    <message>
        <source>the group “%1” has the states %2; expected a placement for each</source>
        <translation>grupa „%1” ma stany %2; oczekiwano położenia dla każdego</translation>
    </message>
    <message>
        <source>the iron bench was cancelled</source>
        <translation>obliczenie na stole żelaza anulowano</translation>
    </message>
    <message>
        <source>circuit “%1”: the sensor stands on its wire; expected 1 mm or more between them</source>
        <translation>obwód „%1”: czujnik stoi na przewodzie; oczekiwano odstępu co najmniej 1 mm</translation>
    </message>
    <message>
        <source>parts are magnetised by the Earth&apos;s field only, not by one another</source>
        <translation>części są magnesowane tylko przez pole Ziemi, nie przez siebie nawzajem</translation>
    </message>
    <message>
        <source>part “%1” is so near the sensor that its field there is uncertain by 10 % and more</source>
        <translation>część „%1” jest tak blisko czujnika, że jej pole jest tam niepewne o 10 % i więcej</translation>
    </message>
    <message>
        <source>part “%1”: the sensor is inside it</source>
        <translation>część „%1”: czujnik jest w jej wnętrzu</translation>
    </message>
    <message>
        <source>a body and the cells of its grid must have sizes above 0 m</source>
        <translation>bryła i komórki jej siatki muszą mieć wymiary większe od 0 m</translation>
    </message>
    <message>
        <source>a grid of %1 cells a side is too coarse; expected %2 or more</source>
        <translation>siatka o %1 komórkach na bok jest za rzadka; oczekiwano %2 lub więcej</translation>
    </message>
    <message>
        <source>a grid of %1 cells a side takes %2 MiB of memory; expected no more than %3 MiB</source>
        <translation>siatka o %1 komórkach na bok zajmuje %2 MiB pamięci; oczekiwano najwyżej %3 MiB</translation>
    </message>
    <message>
        <source>the body is larger than its grid of %1 cells a side</source>
        <translation>bryła jest większa niż jej siatka o %1 komórkach na bok</translation>
    </message>
    <message>
        <source>the demagnetisation tensor was cancelled</source>
        <translation>obliczenie tensora odmagnesowania anulowano</translation>
    </message>
    <message>
        <source>the talker %1 sends no HDG or HDM; these do: %2</source>
        <translation>nadawca %1 nie wysyła HDG ani HDM; wysyłają je: %2</translation>
    </message>
    <message>
        <source>several talkers send headings: %1; HC is taken as the compass</source>
        <translation>kilku nadawców wysyła kursy: %1; za busolę przyjęto HC</translation>
    </message>
    <message>
        <source>several talkers send headings: %1; say which is the compass</source>
        <translation>kilku nadawców wysyła kursy: %1; wskaż, który jest busolą</translation>
    </message>
    <message>
        <source>HDM differs from HDG of the same talker, so it is corrected already; HDG alone is used</source>
        <translation>HDM różni się od HDG tego samego nadawcy, więc jest już poprawiony; użyto tylko HDG</translation>
    </message>
    <message>
        <source>the log tells no position with a date (RMC), so no model can give the variation; expected it stated in degrees</source>
        <translation>zapis nie podaje położenia z datą (RMC), więc żaden model nie da deklinacji; oczekiwano jej podania w stopniach</translation>
    </message>
    <message>
        <source>neither RMC nor HDG of the log tells the variation; expected it stated in degrees, or taken from a model</source>
        <translation>ani RMC, ani HDG w zapisie nie podaje deklinacji; oczekiwano jej podania w stopniach albo wzięcia z modelu</translation>
    </message>
    <message>
        <source>some headings have no time near them: their turn rate is not known and not limited</source>
        <translation>niektóre kursy nie mają czasu w pobliżu: ich prędkość zakrętu nie jest znana ani ograniczona</translation>
    </message>
    <message>
        <source>a valid track (RMC or VTG)</source>
        <translation>ważny kąt drogi (RMC lub VTG)</translation>
    </message>
    <message>
        <source>a second magnetic heading (another talker&apos;s HDG or HDM)</source>
        <translation>drugi kurs magnetyczny (HDG lub HDM innego nadawcy)</translation>
    </message>
    <message>
        <source>holds no NMEA 0183 sentence ($ talker, type, fields): every checksum is wrong</source>
        <translation>nie zawiera komunikatu NMEA 0183 ($ nadawca, typ, pola): wszystkie sumy kontrolne są błędne</translation>
    </message>
    <message>
        <source>holds no NMEA 0183 sentence ($ talker, type, fields)</source>
        <translation>nie zawiera komunikatu NMEA 0183 ($ nadawca, typ, pola)</translation>
    </message>
    <message>
        <source>holds no compass heading; expected HDG or HDM sentences</source>
        <translation>nie zawiera kursu kompasowego; oczekiwano komunikatów HDG lub HDM</translation>
    </message>
    <message>
        <source>there are more than %1 headings; expected the log of one swing</source>
        <translation>kursów jest więcej niż %1; oczekiwano zapisu jednego pomiaru</translation>
    </message>
    <message>
        <source>no figure of the datum instrument; expected one to three</source>
        <translation>brak odczytu wzorca; oczekiwano od jednego do trzech</translation>
    </message>
    <message>
        <source>%1 gives true headings, and the variation is not stated; expected it (degrees, east positive)</source>
        <translation>%1 podaje kursy rzeczywiste, a deklinacji nie podano; oczekiwano jej (stopnie, wschodnia dodatnia)</translation>
    </message>
    <message>
        <source>the datum&apos;s figures %1 lie more than 10° apart; expected readings of one heading</source>
        <translation>odczyty wzorca %1 różnią się o więcej niż 10°; oczekiwano odczytów jednego kursu</translation>
    </message>
    <message>
        <source>the figures from astern %1 lie more than 10° apart; expected readings of one heading</source>
        <translation>odczyty od tyłu %1 różnią się o więcej niż 10°; oczekiwano odczytów jednego kursu</translation>
    </message>
    <message>
        <source>ahead and astern differ by %1° after turning; one of them was read the other way round, or is not of this heading</source>
        <translation>odczyty z przodu i od tyłu po odwróceniu różnią się o %1°; jeden odczytano odwrotnie albo nie dotyczy tego kursu</translation>
    </message>
    <message>
        <source>no figure of the compass; expected one to three</source>
        <translation>brak odczytu busoli; oczekiwano od jednego do trzech</translation>
    </message>
    <message>
        <source>the compass&apos;s figures %1 lie more than 10° apart; expected readings of one heading</source>
        <translation>odczyty busoli %1 różnią się o więcej niż 10°; oczekiwano odczytów jednego kursu</translation>
    </message>
    <message>
        <source>nothing is indicated with %1° selected; expected all four points</source>
        <translation>brak wskazania przy wybranych %1°; oczekiwano wszystkich czterech punktów</translation>
    </message>
    <message>
        <source>with %1° selected the figure is more than 30° off; expected what is indicated there</source>
        <translation>przy wybranych %1° wartość odbiega o ponad 30°; oczekiwano tamtejszego wskazania</translation>
    </message>
    <message>
        <source>the self-check needs all 24 headings both electrically and by the turntable</source>
        <translation>samosprawdzenie wymaga wszystkich 24 kursów elektrycznie i ze stołu obrotowego</translation>
    </message>
    <message>
        <source>the two tables of the self-check are of different headings; expected the same in the same order</source>
        <translation>obie tabele samosprawdzenia mają różne kursy; oczekiwano tych samych w tej samej kolejności</translation>
    </message>
    <message>
        <source>the north–south line is not named</source>
        <translation>nie podano linii północ–południe</translation>
    </message>
    <message>
        <source>E1 and E2 are not both nulled in NORM and REV</source>
        <translation>E1 i E2 nie są oba wyzerowane w NORM i REV</translation>
    </message>
    <message>
        <source>table F1 after the adjustment: %1</source>
        <translation>tabela F1 po kompensacji: %1</translation>
    </message>
    <message>
        <source>the pairs 0/180 and 90/270 do not agree within 0.2°</source>
        <translation>pary 0/180 i 90/270 nie zgadzają się w granicach 0,2°</translation>
    </message>
    <message>
        <source>not all of the 24 headings are read</source>
        <translation>nie odczytano wszystkich 24 kursów</translation>
    </message>
    <message>
        <source>the job was abandoned before</source>
        <translation>pomiar już wcześniej przerwano</translation>
    </message>
    <message>
        <source>step %1 of the guided swing cannot have happened there: %2</source>
        <translation>krok %1 pomiaru prowadzonego nie mógł się tam zdarzyć: %2</translation>
    </message>
    <message>
        <source>the preparation is not finished</source>
        <translation>przygotowanie nie jest zakończone</translation>
    </message>
    <message>
        <source>the fault is not mended</source>
        <translation>usterki nie usunięto</translation>
    </message>
    <message>
        <source>there is no station %1</source>
        <translation>nie ma stanowiska %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not on the checklist</source>
        <translation>„%1” nie ma na liście kontrolnej</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not ticked</source>
        <translation>„%1” nie odhaczono</translation>
    </message>
    <message>
        <source>the station has a reading that was not put aside</source>
        <translation>stanowisko ma odczyt, którego nie odrzucono</translation>
    </message>
    <message>
        <source>the station has no reading</source>
        <translation>stanowisko nie ma odczytu</translation>
    </message>
    <message>
        <source>a control was turned on this reading</source>
        <translation>na tym odczycie obrócono regulację</translation>
    </message>
    <message>
        <source>a station is skipped only with a reason</source>
        <translation>stanowisko można pominąć tylko z podaniem powodu</translation>
    </message>
    <message>
        <source>the station has a reading</source>
        <translation>stanowisko ma odczyt</translation>
    </message>
    <message>
        <source>a control is turned only on a station that was read</source>
        <translation>regulację obraca się tylko na odczytanym stanowisku</translation>
    </message>
    <message>
        <source>a correction is left out only with a reason</source>
        <translation>kompensację pomija się tylko z podaniem powodu</translation>
    </message>
    <message>
        <source>this correction does not stand here</source>
        <translation>ta kompensacja nie przypada tutaj</translation>
    </message>
    <message>
        <source>the check swing is not complete</source>
        <translation>pomiar kontrolny nie jest kompletny</translation>
    </message>
    <message>
        <source>the index is left in only with a reason</source>
        <translation>nastawienie pozostawia się tylko z podaniem powodu</translation>
    </message>
    <message>
        <source>the swing is not complete</source>
        <translation>pomiar nie jest kompletny</translation>
    </message>
    <message>
        <source>a fault has a cause</source>
        <translation>usterka ma przyczynę</translation>
    </message>
    <message>
        <source>there is no fault</source>
        <translation>nie ma usterki</translation>
    </message>
    <message>
        <source>the check swing has too few readings to tell A</source>
        <translation>pomiar kontrolny ma za mało odczytów, by określić A</translation>
    </message>
    <message>
        <source>a cardinal heading was skipped, so that the coefficient cannot be told by the classical rule</source>
        <translation>pominięto kurs główny, więc klasyczna reguła nie określi współczynnika</translation>
    </message>
    <message>
        <source>its date is not stated</source>
        <translation>nie podano daty</translation>
    </message>
    <message>
        <source>reading %1 has no compass heading; fill it in or exclude it with a reason</source>
        <translation>odczyt %1 nie ma kursu kompasowego; uzupełnij go albo pomiń z podaniem powodu</translation>
    </message>
    <message>
        <source>reading %1 has no magnetic heading; fill it in or exclude it with a reason</source>
        <translation>odczyt %1 nie ma kursu magnetycznego; uzupełnij go albo pomiń z podaniem powodu</translation>
    </message>
    <message>
        <source>check swing</source>
        <translation>pomiar kontrolny</translation>
    </message>
    <message>
        <source>correction swing</source>
        <translation>pomiar kompensacyjny</translation>
    </message>
    <message>
        <source>calibration swing</source>
        <translation>pomiar wzorcujący</translation>
    </message>
    <message>
        <source>air swing</source>
        <translation>pomiar w locie</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>stan zastany</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>stan końcowy</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>szkic</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>zakończony</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>podpisany</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>on</source>
        <translation>włączone</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wyłączone</translation>
    </message>
    <message>
        <source>direct reading</source>
        <translation>o odczycie bezpośrednim</translation>
    </message>
    <message>
        <source>remote, not stabilised</source>
        <translation>zdalna, niestabilizowana</translation>
    </message>
    <message>
        <source>remote, gyro-stabilised</source>
        <translation>zdalna, stabilizowana żyroskopowo</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nieznany</translation>
    </message>
    <message>
        <source>screws</source>
        <translation>śruby</translation>
    </message>
    <message>
        <source>magnets</source>
        <translation>magnesy</translation>
    </message>
    <message>
        <source>electronic</source>
        <translation>elektroniczny</translation>
    </message>
    <message>
        <source>entered by hand</source>
        <translation>wpisany ręcznie</translation>
    </message>
    <message>
        <source>loaded from a file</source>
        <translation>wczytany z pliku</translation>
    </message>
    <message>
        <source>estimated from swings</source>
        <translation>oszacowany z pomiarów</translation>
    </message>
    <message>
        <source>computed on the iron bench</source>
        <translation>obliczony na stole żelaza</translation>
    </message>
    <message>
        <source>swung and adjusted by</source>
        <translation>zmierzył i skompensował</translation>
    </message>
    <message>
        <source>inspected by</source>
        <translation>sprawdził</translation>
    </message>
    <message>
        <source>released by</source>
        <translation>dopuścił</translation>
    </message>
    <message>
        <source>painted rose line</source>
        <translation>namalowana linia kręgu</translation>
    </message>
    <message>
        <source>sighting compass</source>
        <translation>busola celownicza</translation>
    </message>
    <message>
        <source>theodolite</source>
        <translation>teodolit</translation>
    </message>
    <message>
        <source>digital compass on the aircraft</source>
        <translation>busola cyfrowa na statku powietrznym</translation>
    </message>
    <message>
        <source>transfer gyro</source>
        <translation>żyroskop przenośny</translation>
    </message>
    <message>
        <source>astrocompass</source>
        <translation>astrokompas</translation>
    </message>
    <message>
        <source>runway direction</source>
        <translation>kierunek drogi startowej</translation>
    </message>
    <message>
        <source>INS or GPS</source>
        <translation>INS lub GPS</translation>
    </message>
    <message>
        <source>electrical calibrator</source>
        <translation>kalibrator elektryczny</translation>
    </message>
    <message>
        <source>the aircraft&apos;s heading</source>
        <translation>kurs statku powietrznego</translation>
    </message>
    <message>
        <source>its reciprocal</source>
        <translation>kurs przeciwny</translation>
    </message>
    <message>
        <source>no class</source>
        <translation>bez klasy</translation>
    </message>
    <message>
        <source>class 1</source>
        <translation>klasa 1</translation>
    </message>
    <message>
        <source>class 2</source>
        <translation>klasa 2</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>coś innego</translation>
    </message>
    <message>
        <source>ferrous parts or compass replaced</source>
        <translation>wymiana części stalowych lub busoli</translation>
    </message>
    <message>
        <source>engine change</source>
        <translation>wymiana silnika</translation>
    </message>
    <message>
        <source>cockpit or avionics modified</source>
        <translation>modyfikacja kabiny lub awioniki</translation>
    </message>
    <message>
        <source>electrical system changed</source>
        <translation>zmiana instalacji elektrycznej</translation>
    </message>
    <message>
        <source>lightning strike</source>
        <translation>uderzenie pioruna</translation>
    </message>
    <message>
        <source>severe electrical storm</source>
        <translation>silna burza z wyładowaniami</translation>
    </message>
    <message>
        <source>hard landing or shock</source>
        <translation>twarde lądowanie lub wstrząs</translation>
    </message>
    <message>
        <source>magnetic cargo</source>
        <translation>ładunek magnetyczny</translation>
    </message>
    <message>
        <source>moved to a very different field</source>
        <translation>przebazowanie w bardzo odmienne pole</translation>
    </message>
    <message>
        <source>parked on one heading over a year</source>
        <translation>postój na jednym kursie ponad rok</translation>
    </message>
    <message>
        <source>accuracy suspected</source>
        <translation>wątpliwa dokładność</translation>
    </message>
    <message>
        <source>Coefficient method</source>
        <translation>Metoda współczynników</translation>
    </message>
    <message>
        <source>Half-error method</source>
        <translation>Metoda połowy błędu</translation>
    </message>
    <message>
        <source>Index first</source>
        <translation>Najpierw nastawienie</translation>
    </message>
    <message>
        <source>Flux valve</source>
        <translation>Czujnik indukcyjny</translation>
    </message>
    <message>
        <source>Check only</source>
        <translation>Tylko kontrola</translation>
    </message>
    <message>
        <source>N–S screw</source>
        <translation>śruba N–S</translation>
    </message>
    <message>
        <source>E–W screw</source>
        <translation>śruba E–W</translation>
    </message>
    <message>
        <source>compass in its mount</source>
        <translation>busola w obsadzie</translation>
    </message>
    <message>
        <source>date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>rodzaj</translation>
    </message>
    <message>
        <source>stage</source>
        <translation>etap</translation>
    </message>
    <message>
        <source>site</source>
        <translation>miejsce</translation>
    </message>
    <message>
        <source>another</source>
        <translation>inne</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>zmieniono</translation>
    </message>
    <message>
        <source>radio</source>
        <translation>radio</translation>
    </message>
    <message>
        <source>engines</source>
        <translation>silniki</translation>
    </message>
    <message>
        <source>electrics</source>
        <translation>odbiorniki elektryczne</translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>konfiguracja</translation>
    </message>
    <message>
        <source>datum</source>
        <translation>wzorzec</translation>
    </message>
    <message>
        <source>datum serial number</source>
        <translation>numer seryjny wzorca</translation>
    </message>
    <message>
        <source>datum calibration due</source>
        <translation>wzorcowanie wzorca do</translation>
    </message>
    <message>
        <source>datum read-out</source>
        <translation>sposób odczytu wzorca</translation>
    </message>
    <message>
        <source>datum reader</source>
        <translation>odczytujący wzorzec</translation>
    </message>
    <message>
        <source>cockpit reader</source>
        <translation>odczytujący w kabinie</translation>
    </message>
    <message>
        <source>adjuster</source>
        <translation>kompensujący</translation>
    </message>
    <message>
        <source>inspector</source>
        <translation>kontroler</translation>
    </message>
    <message>
        <source>variation</source>
        <translation>deklinacja</translation>
    </message>
    <message>
        <source>index removed</source>
        <translation>usunięte nastawienie</translation>
    </message>
    <message>
        <source>procedure</source>
        <translation>metoda</translation>
    </message>
    <message>
        <source>start</source>
        <translation>początek</translation>
    </message>
    <message>
        <source>end</source>
        <translation>koniec</translation>
    </message>
    <message>
        <source>site override</source>
        <translation>uzasadnienie miejsca</translation>
    </message>
    <message>
        <source>weather</source>
        <translation>pogoda</translation>
    </message>
    <message>
        <source>work order</source>
        <translation>zlecenie</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>powód</translation>
    </message>
    <message>
        <source>note</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <source>field model</source>
        <translation>model pola</translation>
    </message>
    <message>
        <source>field</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>another place, day or value</source>
        <translation>inne miejsce, dzień lub wartość</translation>
    </message>
    <message>
        <source>reading %1, nominal</source>
        <translation>odczyt %1, nominalny</translation>
    </message>
    <message>
        <source>reading %1, magnetic</source>
        <translation>odczyt %1, magnetyczny</translation>
    </message>
    <message>
        <source>reading %1, compass</source>
        <translation>odczyt %1, kompasowy</translation>
    </message>
    <message>
        <source>reading %1, true</source>
        <translation>odczyt %1, rzeczywisty</translation>
    </message>
    <message>
        <source>reading %1, time</source>
        <translation>odczyt %1, czas</translation>
    </message>
    <message>
        <source>reading %1, pitch</source>
        <translation>odczyt %1, pochylenie</translation>
    </message>
    <message>
        <source>reading %1, roll</source>
        <translation>odczyt %1, przechylenie</translation>
    </message>
    <message>
        <source>reading %1, datum figures</source>
        <translation>odczyt %1, wartości wzorca</translation>
    </message>
    <message>
        <source>reading %1, astern figures</source>
        <translation>odczyt %1, wartości od tyłu</translation>
    </message>
    <message>
        <source>reading %1, compass figures</source>
        <translation>odczyt %1, wartości busoli</translation>
    </message>
    <message>
        <source>reading %1, excluded</source>
        <translation>odczyt %1, pominięcie</translation>
    </message>
    <message>
        <source>reading %1, note</source>
        <translation>odczyt %1, uwaga</translation>
    </message>
    <message>
        <source>both axes of the map are the same; expected two of heading, pitch and roll</source>
        <translation>obie osie mapy są takie same; oczekiwano dwóch spośród kursu, pochylenia i przechylenia</translation>
    </message>
    <message>
        <source>a map has at least 2 x 2 points; asked for %1 x %2</source>
        <translation>mapa ma co najmniej 2 x 2 punkty; zażądano %1 x %2</translation>
    </message>
    <message>
        <source>a map of %1 x %2 has %3 points and takes %4 MiB; expected at most %5 points</source>
        <translation>mapa %1 x %2 ma %3 punktów i zajmuje %4 MiB; oczekiwano najwyżej %5 punktów</translation>
    </message>
    <message>
        <source>soft iron %1 (dip)</source>
        <translation>żelazo miękkie %1 (inklinacja)</translation>
    </message>
    <message>
        <source>soft iron %1</source>
        <translation>żelazo miękkie %1</translation>
    </message>
    <message>
        <source>hard iron %1</source>
        <translation>żelazo twarde %1</translation>
    </message>
    <message>
        <source>soft constant %1</source>
        <translation>stała składowa miękka %1</translation>
    </message>
    <message>
        <source>circuit %1</source>
        <translation>obwód %1</translation>
    </message>
    <message>
        <source>misalignment</source>
        <translation>niewspółosiowość</translation>
    </message>
    <message>
        <source>the horizontal field H is 0: a level compass has nothing to point by there; expected H &gt; 0</source>
        <translation>pole poziome H wynosi 0: pozioma busola nie ma się tam czym kierować; oczekiwano H &gt; 0</translation>
    </message>
    <message>
        <source>λ = %1: the iron (or the mount) turns the compass round, and no coefficients describe it; expected λ &gt; 0</source>
        <translation>λ = %1: żelazo (albo mocowanie) obraca busolę i nie opisują tego żadne współczynniki; oczekiwano λ &gt; 0</translation>
    </message>
    <message>
        <source>the coefficients are beyond all numbers: H = %1 nT and λ = %2 are too small for the iron</source>
        <translation>współczynniki wykraczają poza wszelkie liczby: H = %1 nT i λ = %2 są za małe dla tego żelaza</translation>
    </message>
    <message>
        <source>a survey point is not a number; expected metres, degrees and nT</source>
        <translation>punkt pomiaru kręgu nie jest liczbą; oczekiwano metrów, stopni i nT</translation>
    </message>
    <message>
        <source>no point of the survey has a declination or a total field; expected at least one</source>
        <translation>żaden punkt pomiaru kręgu nie ma deklinacji ani pola całkowitego; oczekiwano co najmniej jednego</translation>
    </message>
    <message>
        <source>the base&apos;s certificate ended on %1</source>
        <translation>świadectwo kręgu dewiacyjnego wygasło %1</translation>
    </message>
    <message>
        <source>the base is of %1, and the procedure wants %2</source>
        <translation>krąg dewiacyjny: %1, a metoda wymaga: %2</translation>
    </message>
    <message>
        <source>no reading between %1 and %2 (compass)</source>
        <translation>brak odczytu między %1 a %2 (kursy kompasowe)</translation>
    </message>
    <message>
        <source>%1 coefficients lean on few headings: %2</source>
        <translation>współczynniki (%1) opierają się na niewielu kursach: %2</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>przybliżone</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>dokładne</translation>
    </message>
    <message>
        <source>%1 cannot be told from these headings; expected readings all around the compass</source>
        <translation>na tych kursach nie da się określić: %1; oczekiwano odczytów dookoła róży</translation>
    </message>
    <message>
        <source>coefficient %1</source>
        <translation>współczynnik %1</translation>
    </message>
    <message>
        <source>the deviation curve</source>
        <translation>krzywa dewiacji</translation>
    </message>
    <message>
        <source>the dip is 0 at every place (%1): vertical soft iron shows nowhere and cannot be told</source>
        <translation>inklinacja wynosi wszędzie 0 (%1): pionowe żelazo miękkie nigdzie się nie ujawnia i nie można go określić</translation>
    </message>
    <message>
        <source>the field is the same at all places (%1): hard iron and vertical soft iron cannot be told apart; expected swings where H and dip differ</source>
        <translation>pole jest we wszystkich miejscach takie samo (%1): żelaza twardego i pionowego miękkiego nie można rozdzielić; oczekiwano pomiarów przy różnych H i inklinacji</translation>
    </message>
    <message>
        <source>the fields at %1 are too alike: hard iron and vertical soft iron are told apart only roughly</source>
        <translation>pola w %1 są zbyt podobne: żelazo twarde i pionowe miękkie rozdzielono tylko z grubsza</translation>
    </message>
    <message>
        <source>the swings&apos; own errors are not known, and two swings have no scatter: no errors can be stated</source>
        <translation>błędy własne pomiarów są nieznane, a dwa pomiary nie mają rozrzutu: nie można podać błędów</translation>
    </message>
    <message>
        <source>the swings contradict each other beyond their errors: something was changed between them, or a swing is wrong</source>
        <translation>pomiary przeczą sobie ponad swoje błędy: coś między nimi zmieniono albo któryś jest błędny</translation>
    </message>
    <message>
        <source>one swing cannot tell hard iron from vertical soft iron; expected swings of the compass at two places at least</source>
        <translation>jeden pomiar nie odróżni żelaza twardego od pionowego miękkiego; oczekiwano pomiarów busoli co najmniej w dwóch miejscach</translation>
    </message>
    <message>
        <source>the field of %1 is not known; expected H above 0 and the dip</source>
        <translation>pole dla %1 nie jest znane; oczekiwano H powyżej 0 i inklinacji</translation>
    </message>
    <message>
        <source>(d − b)/2λ = A = %1 (with the turn of the mount)</source>
        <translation>(d − b)/2λ = A = %1 (z obrotem mocowania)</translation>
    </message>
    <message>
        <source>(a − e)/2λ = D = %1</source>
        <translation>(a − e)/2λ = D = %1</translation>
    </message>
    <message>
        <source>(d + b)/2λ = E = %1</source>
        <translation>(d + b)/2λ = E = %1</translation>
    </message>
    <message>
        <source>(c tan I + P/H)/λ = B = %1</source>
        <translation>(c tan I + P/H)/λ = B = %1</translation>
    </message>
    <message>
        <source>(f tan I + Q/H)/λ = C = %1</source>
        <translation>(f tan I + Q/H)/λ = C = %1</translation>
    </message>
    <message>
        <source>vertical soft iron: c/λ = %1, f/λ = %2</source>
        <translation>pionowe żelazo miękkie: c/λ = %1, f/λ = %2</translation>
    </message>
    <message>
        <source>hard iron: P/λ = %1 nT, Q/λ = %2 nT</source>
        <translation>żelazo twarde: P/λ = %1 nT, Q/λ = %2 nT</translation>
    </message>
    <message>
        <source>c apart from P, f apart from Q: one place gives their sum; a swing where H and dip differ tells them apart</source>
        <translation>c oddzielnie od P, f oddzielnie od Q: jedno miejsce daje ich sumę; rozróżni je pomiar tam, gdzie H i inklinacja są inne</translation>
    </message>
    <message>
        <source>λ, the directive force: a compass shows directions, not sizes</source>
        <translation>λ, siła kierująca: busola pokazuje kierunki, nie wielkości</translation>
    </message>
    <message>
        <source>a and e each, b and d each: on a level heading only a − e, d + b and d − b act</source>
        <translation>a i e osobno, b i d osobno: na poziomym kursie działają tylko a − e, d + b i d − b</translation>
    </message>
    <message>
        <source>g, h, k and R: they act in pitch and roll only</source>
        <translation>g, h, k i R: działają tylko przy pochyleniu i przechyleniu</translation>
    </message>
    <message>
        <source>the turn of the mount apart from (d − b)/2λ, and its tilt</source>
        <translation>obrót mocowania oddzielnie od (d − b)/2λ oraz jego pochylenie</translation>
    </message>
    <message>
        <source>soft-iron constants and currents apart from hard iron: both are constant in body axes</source>
        <translation>stałe żelaza miękkiego i prądów oddzielnie od żelaza twardego: oba są stałe w osiach płatowca</translation>
    </message>
    <message>
        <source>the dip is 0 there: vertical soft iron cannot have made B and C</source>
        <translation>inklinacja wynosi tam 0: pionowe żelazo miękkie nie mogło dać B i C</translation>
    </message>
    <message>
        <source>the position of %1 is not stated; expected latitude and longitude</source>
        <translation>nie podano położenia %1; oczekiwano szerokości i długości geograficznej</translation>
    </message>
    <message>
        <source>based at %1: %2</source>
        <translation>baza %1: %2</translation>
    </message>
    <message>
        <source>H there is %1 nT, below 2000 nT (blackout zone): a compass tells nothing there</source>
        <translation>H wynosi tam %1 nT, poniżej 2000 nT (strefa zakazana): busola niczego tam nie wskazuje</translation>
    </message>
    <message>
        <source>caution zone: H there is below 6000 nT, compasses are unreliable</source>
        <translation>strefa ostrożności: H wynosi tam poniżej 6000 nT, busole są niepewne</translation>
    </message>
    <message>
        <source>a sensor model</source>
        <translation>model czujnika</translation>
    </message>
    <message>
        <source>H differs by more than a factor of two between the places</source>
        <translation>H w obu miejscach różni się ponad dwukrotnie</translation>
    </message>
    <message>
        <source>swings at several places</source>
        <translation>pomiary w kilku miejscach</translation>
    </message>
    <message>
        <source>up to %1 is expected there, beyond the limit</source>
        <translation>oczekuje się tam do %1, ponad wartość dopuszczalną</translation>
    </message>
    <message>
        <source>coefficient %1 cannot be removed: these headings do not tell it</source>
        <translation>współczynnika %1 nie da się usunąć: te kursy go nie określają</translation>
    </message>
    <message>
        <source>the Earth&apos;s field of the swing of %1 is not known; expected a site with latitude and longitude, and a date within the magnetic models</source>
        <translation>pole Ziemi dla pomiaru %1 nie jest znane; oczekiwano miejsca z szerokością i długością geograficzną oraz daty objętej modelami magnetycznymi</translation>
    </message>
    <message>
        <source>the readings of the swing of %1 do not tell all five coefficients; expected five headings at least, round the compass</source>
        <translation>odczyty pomiaru %1 nie określają wszystkich pięciu współczynników; oczekiwano co najmniej pięciu kursów dookoła róży</translation>
    </message>
    <message>
        <source>%1 is %2; expected %3</source>
        <translation>%1 – %2; oczekiwano %3</translation>
    </message>
    <message>
        <source>not clear: an O is east in German and west in French</source>
        <translation>niejasne: O to wschód po niemiecku, a zachód po francusku</translation>
    </message>
    <message>
        <source>a sign or %1 or %2, not both</source>
        <translation>znak albo %1 lub %2, nie oba naraz</translation>
    </message>
    <message>
        <source>a true heading</source>
        <translation>kurs rzeczywisty</translation>
    </message>
    <message>
        <source>a magnetic heading</source>
        <translation>kurs magnetyczny</translation>
    </message>
    <message>
        <source>a compass heading</source>
        <translation>kurs kompasowy</translation>
    </message>
    <message>
        <source>degrees from 0 to 360, such as 47.5 or 47°30&apos;, or a point such as NE</source>
        <translation>stopni od 0 do 360, na przykład 47.5 lub 47°30&apos;, albo punktu róży, jak NE</translation>
    </message>
    <message>
        <source>not a bearing from north or south</source>
        <translation>to nie namiar od północy ani południa</translation>
    </message>
    <message>
        <source>0 to 90 degrees, such as N 45 E</source>
        <translation>od 0 do 90 stopni, na przykład N 45 E</translation>
    </message>
    <message>
        <source>degrees from -%1 to %1, such as 3.25 or -3°15&apos;</source>
        <translation>stopni od -%1 do %1, na przykład 3.25 lub -3°15&apos;</translation>
    </message>
    <message>
        <source>degrees from -90 to 90, north positive, such as 51.55, 51°33&apos;N or 33.9 S</source>
        <translation>stopni od -90 do 90, północne dodatnie, na przykład 51.55, 51°33&apos;N lub 33.9 S</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>poza zakresem</translation>
    </message>
    <message>
        <source>is %1; expected UTF-8: save it with the character set UTF-8 (in Excel: &quot;CSV UTF-8&quot;)</source>
        <translation>jest w kodowaniu %1; oczekiwano UTF-8: zapisz plik w zestawie znaków UTF-8 (w Excelu: „CSV UTF-8”)</translation>
    </message>
    <message>
        <source>UTF-16 without its byte order mark</source>
        <translation>UTF-16 bez znacznika kolejności bajtów</translation>
    </message>
    <message>
        <source>the byte %1 behind %2 is not UTF-8 (the file is in a code page such as Windows-1252); expected UTF-8: save it with the character set UTF-8 (in Excel: &quot;CSV UTF-8&quot;)</source>
        <translation>bajt %1 po %2 nie jest UTF-8 (plik jest w stronie kodowej, na przykład Windows-1252); oczekiwano UTF-8: zapisz plik w zestawie znaków UTF-8 (w Excelu: „CSV UTF-8”)</translation>
    </message>
    <message>
        <source>standard output takes no more; expected one that is read to its end</source>
        <translation>standardowe wyjście nie przyjmuje więcej danych; oczekiwano czytanego do końca</translation>
    </message>
    <message>
        <source>a file of magnetic coefficients</source>
        <translation>plik współczynników magnetycznych</translation>
    </message>
    <message>
        <source>ends without its line of nines behind degree %1: whether more degrees are missing cannot be told; expected a line of 48 nines at its end</source>
        <translation>kończy się bez linii dziewiątek po stopniu %1: nie da się stwierdzić, czy brakuje dalszych stopni; oczekiwano na końcu linii z 48 dziewiątek</translation>
    </message>
    <message>
        <source>ends without its line of nines within degree %1, before order %2: it is cut short</source>
        <translation>kończy się bez linii dziewiątek w stopniu %1, przed rzędem %2: jest ucięty</translation>
    </message>
    <message>
        <source>has one epoch and no column of the yearly change (as &quot;2025-30&quot;), so it says nothing of any other year; expected both</source>
        <translation>ma jedną epokę i nie ma kolumny zmian rocznych (jak „2025-30”), więc nie mówi nic o innym roku; oczekiwano obu</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>anulowano</translation>
    </message>
    <message>
        <source>A alone: the compass or detector was turned in its mount</source>
        <translation>samo A: busolę lub detektor obrócono w mocowaniu</translation>
    </message>
    <message>
        <source>B and C: permanent magnetism, of the aircraft or of the compensating magnets</source>
        <translation>B i C: magnetyzm stały statku powietrznego albo magnesów kompensujących</translation>
    </message>
    <message>
        <source>D and E of a remote compass: the transmission of its signal (two-cycle error), or soft iron near the detector</source>
        <translation>D i E busoli zdalnej: przekazywanie sygnału (błąd dwuokresowy) albo żelazo miękkie przy detektorze</translation>
    </message>
    <message>
        <source>D and E: soft iron, the correctors or parts near the compass</source>
        <translation>D i E: żelazo miękkie, korektory albo części przy busoli</translation>
    </message>
    <message>
        <source>several coefficients at once: iron near the compass was changed, or the compass itself</source>
        <translation>kilka współczynników naraz: zmieniono żelazo przy busoli albo samą busolę</translation>
    </message>
    <message>
        <source>%1 aircraft types are in one selection: their mean is that of no aircraft</source>
        <translation>w jednym wyborze są typy statków powietrznych: %1; ich średnia nie dotyczy żadnego statku powietrznego</translation>
    </message>
    <message>
        <source>%1 compass systems are in one selection: choose one for a pattern that an aircraft has</source>
        <translation>w jednym wyborze są układy busoli: %1; wybierz jeden, aby wzór był wzorem statku powietrznego</translation>
    </message>
    <message>
        <source>swings with the radio on and off are in one selection: choose one state</source>
        <translation>w jednym wyborze są pomiary z radiem włączonym i wyłączonym: wybierz jeden stan</translation>
    </message>
    <message>
        <source>one aircraft is no population: no spread between aircraft can be told</source>
        <translation>jeden statek powietrzny to nie populacja: rozrzutu między statkami nie da się podać</translation>
    </message>
    <message>
        <source>no pair of a swing as left and the next as found: how often limits are exceeded between inspections cannot be told</source>
        <translation>brak pary: pomiar w stanie pozostawionym i następny w zastanym; nie da się podać, jak często przekracza się granice między przeglądami</translation>
    </message>
    <message>
        <source>the compasses have different limits: an expected share is told for one limit only</source>
        <translation>busole mają różne wartości dopuszczalne: udział oczekiwany podaje się tylko dla jednej</translation>
    </message>
    <message>
        <source>few swings of a kind: how much they scatter and wander is itself uncertain; intervals are wide for it</source>
        <translation>mało pomiarów jednego rodzaju: ich rozrzut i powolne zmiany same są niepewne; przedziały są przez to szerokie</translation>
    </message>
    <message>
        <source>a grid of %1 headings; expected 3 to 360</source>
        <translation>siatka %1 kursów; oczekiwano od 3 do 360</translation>
    </message>
    <message>
        <source>no swing is in the selection; expected at least one that is complete</source>
        <translation>w wyborze nie ma pomiaru; oczekiwano co najmniej jednego ukończonego</translation>
    </message>
    <message>
        <source>%1 · %2: %3 jumped by %4° (standard error %5°) between %6 and %7</source>
        <translation>%1 · %2: %3 skoczył o %4° (błąd standardowy %5°) między %6 a %7</translation>
    </message>
    <message>
        <source>crew %1</source>
        <translation>załoga %1</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>baza %1</translation>
    </message>
    <message>
        <source>east of</source>
        <translation>na wschód od</translation>
    </message>
    <message>
        <source>west of</source>
        <translation>na zachód od</translation>
    </message>
    <message>
        <source>fell by %1 %</source>
        <translation>spadła o %1 %</translation>
    </message>
    <message>
        <source>rose by %1 %</source>
        <translation>wzrosła o %1 %</translation>
    </message>
    <message>
        <source>mean |A| %1, from %2° in %3 swings to %4° in %5</source>
        <translation>średnie |A|: %1, z %2° w %3 pomiarach do %4° w %5</translation>
    </message>
    <message>
        <source>compared at %1, as was asked</source>
        <translation>porównanie na %1, jak zażądano</translation>
    </message>
    <message>
        <source>the change lies between the swings of %1 and %2</source>
        <translation>zmiana leży między pomiarami z %1 i %2</translation>
    </message>
    <message>
        <source>of the %1 compasses that were swung on both sides alone, the mean |A| changed by %2 %</source>
        <translation>dla samych %1 busol mierzonych po obu stronach średnie |A| zmieniło się o %2 %</translation>
    </message>
    <message>
        <source>no compass was swung on both sides: the change cannot be told from one of the aircraft</source>
        <translation>żadnej busoli nie mierzono po obu stronach: zmiany nie da się odróżnić od zmiany statków powietrznych</translation>
    </message>
    <message>
        <source>what else changed at that date (crews, datum instrument, base) cannot be told from training by these figures</source>
        <translation>co jeszcze zmieniło się w tym dniu (załogi, przyrząd wzorcowy, baza), tego z tych liczb nie da się odróżnić od szkolenia</translation>
    </message>
    <message>
        <source>%1° by its last swing, beyond its limit of %2°</source>
        <translation>%1° w ostatnim pomiarze, poza granicą %2°</translation>
    </message>
    <message>
        <source>%1 drifts by %2° a year</source>
        <translation>%1 dryfuje o %2° rocznie</translation>
    </message>
    <message>
        <source>%1 jumped by %2°</source>
        <translation>skok %1 o %2°</translation>
    </message>
    <message>
        <source>%1° expected, near its limit of %2°</source>
        <translation>oczekiwane %1°, blisko granicy %2°</translation>
    </message>
    <message>
        <source>%1 years since its last swing by then</source>
        <translation>do tego czasu %1 lat od ostatniego pomiaru</translation>
    </message>
    <message>
        <source>%1° expected of a limit of %2°</source>
        <translation>oczekiwane %1° przy granicy %2°</translation>
    </message>
    <message>
        <source>crew: most swings name none</source>
        <translation>załoga: większość pomiarów jej nie podaje</translation>
    </message>
    <message>
        <source>base: most swings name none</source>
        <translation>baza: większość pomiarów jej nie podaje</translation>
    </message>
    <message>
        <source>aircraft: each has one swing, so that it cannot be told from a reading</source>
        <translation>statek powietrzny: każdy ma jeden pomiar, więc nie da się go odróżnić od odczytu</translation>
    </message>
    <message>
        <source>aircraft: there is one</source>
        <translation>statek powietrzny: jest jeden</translation>
    </message>
    <message>
        <source>base: there is one</source>
        <translation>baza: jest jedna</translation>
    </message>
    <message>
        <source>crew: there is one</source>
        <translation>załoga: jest jedna</translation>
    </message>
    <message>
        <source>crew: each made one swing</source>
        <translation>załoga: każda wykonała jeden pomiar</translation>
    </message>
    <message>
        <source>base: each had one swing</source>
        <translation>baza: każda miała jeden pomiar</translation>
    </message>
    <message>
        <source>crew: each had one aircraft, and each aircraft one crew</source>
        <translation>załoga: każda miała jeden statek powietrzny, a każdy statek jedną załogę</translation>
    </message>
    <message>
        <source>base: each had one aircraft, and each aircraft one base</source>
        <translation>baza: każda miała jeden statek powietrzny, a każdy statek jedną bazę</translation>
    </message>
    <message>
        <source>crew and base: each base has one crew, so that what is told as the base&apos;s may be the crew&apos;s</source>
        <translation>załoga i baza: każda baza ma jedną załogę, więc to, co przypisano bazie, może pochodzić od załogi</translation>
    </message>
    <message>
        <source>crew: there are more of them than are told apart here</source>
        <translation>załoga: jest ich więcej, niż tu się rozróżnia</translation>
    </message>
    <message>
        <source>base: there are more of them than are told apart here</source>
        <translation>baza: jest ich więcej, niż tu się rozróżnia</translation>
    </message>
    <message>
        <source>fewer than two swings: no variance can be told</source>
        <translation>mniej niż dwa pomiary: nie da się podać wariancji</translation>
    </message>
    <message>
        <source>all swings are equal: there is no variance to be divided</source>
        <translation>wszystkie pomiary są równe: nie ma wariancji do podziału</translation>
    </message>
    <message>
        <source>%1 is what a spreadsheet writes where it cannot compute; expected a heading</source>
        <translation>%1 to zapis arkusza, który nie mógł czegoś obliczyć; oczekiwano kursu</translation>
    </message>
    <message>
        <source>lines %1 and %2 list one heading, 000 and 360, with different readings, %3 and %4: both count, so look which is right</source>
        <translation>wiersze %1 i %2 podają ten sam kurs, 000 i 360, z różnymi odczytami, %3 i %4: liczą się oba, więc sprawdź, który jest właściwy</translation>
    </message>
    <message>
        <source>lines %1 and %2 list one heading, 000 and 360, with the same reading: it counts once</source>
        <translation>wiersze %1 i %2 podają ten sam kurs, 000 i 360, z tym samym odczytem: liczy się raz</translation>
    </message>
    <message>
        <source>a Swing CSV</source>
        <translation>plik CSV pomiaru</translation>
    </message>
    <message>
        <source>%1: the cell is empty; expected degrees, such as 47.5</source>
        <translation>%1: komórka jest pusta; oczekiwano stopni, na przykład 47.5</translation>
    </message>
    <message>
        <source>a true heading (HDT or THS)</source>
        <translation>kurs rzeczywisty (HDT lub THS)</translation>
    </message>
    <message>
        <source>the RMC and VTG of the log hold no track with a speed; expected an aircraft that moves</source>
        <translation>RMC i VTG w zapisie nie zawierają kąta drogi z prędkością; oczekiwano poruszającego się statku powietrznego</translation>
    </message>
    <message>
        <source>no compass heading stands beside %1; expected a log that holds both</source>
        <translation>obok %1 nie ma kursu kompasowego; oczekiwano zapisu, który zawiera oba</translation>
    </message>
    <message>
        <source>the true heading is a speed log&apos;s (VHW), which mostly is the compass&apos;s own with the variation added: such a reference shows no deviation</source>
        <translation>kurs rzeczywisty pochodzi z logu prędkości (VHW), który zwykle podaje kurs samej busoli z dodaną deklinacją: taki wzorzec nie pokaże dewiacji</translation>
    </message>
    <message>
        <source>the true heading %1 is sent by a magnetic compass: it is no reference for one</source>
        <translation>kurs rzeczywisty %1 wysyła busola magnetyczna: nie może być dla niej odniesieniem</translation>
    </message>
    <message>
        <source>holds no compass heading: all are negative or beyond 360</source>
        <translation>nie zawiera kursu kompasowego: wszystkie są ujemne lub większe niż 360</translation>
    </message>
    <message>
        <source>wind from %1° true at %2 kt (standard error %3 kt), airspeed %4 kt, is taken out of the tracks</source>
        <translation>wiatr z %1° rzeczywistych, %2 w (błąd standardowy %3 w), prędkość powietrzna %4 w, został odjęty od kątów drogi</translation>
    </message>
    <message>
        <source>the reference is %1 s older than the heading beside it (standard error %2 s); that is taken out</source>
        <translation>wzorzec jest o %1 s starszy niż kurs obok niego (błąd standardowy %2 s); zostało to odjęte</translation>
    </message>
    <message>
        <source>most of the turn is faster than %1°/s: a card in its liquid lags; %2 to %1°/s tells more</source>
        <translation>większa część obrotu jest szybsza niż %1°/s: róża w cieczy się opóźnia; %2 do %1°/s powie więcej</translation>
    </message>
    <message>
        <source>clockwise A is %1°, counter-clockwise %2°; the two curves differ by up to %3°</source>
        <translation>w prawo A wynosi %1°, w lewo %2°; obie krzywe różnią się do %3°</translation>
    </message>
    <message>
        <source>no compass heading of %1 has a reference (%2) near its time</source>
        <translation>żaden kurs kompasowy %1 nie ma odniesienia (%2) o zbliżonym czasie</translation>
    </message>
    <message>
        <source>is UTF-16 text (a Windows editor&apos;s or shell&apos;s &quot;Unicode&quot;); expected plain text: save it once more as UTF-8 or ASCII</source>
        <translation>to tekst UTF-16 („Unicode” edytora lub powłoki Windows); oczekiwano zwykłego tekstu: zapisz go jeszcze raz jako UTF-8 lub ASCII</translation>
    </message>
    <message>
        <source>an NMEA log</source>
        <translation>zapis NMEA</translation>
    </message>
    <message>
        <source>%1 dates the log %2, and not %3</source>
        <translation>%1 datuje zapis na %2, a nie %3</translation>
    </message>
    <message>
        <source>the log tells different variations: %1 (east +); that of %2 is taken</source>
        <translation>zapis podaje różne deklinacje: %1 (wschodnia +); przyjęto deklinację %2</translation>
    </message>
    <message>
        <source>the variation stated is %1° (east +), that of %2 is %3°: they are %4° apart</source>
        <translation>podana deklinacja wynosi %1° (wschodnia +), według %2 %3°: różnią się o %4°</translation>
    </message>
    <message>
        <source>its date %1 is still to come (today is %2); expected the day on which it was swung</source>
        <translation>data %1 jeszcze nie nadeszła (dziś jest %2); oczekiwano dnia pomiaru</translation>
    </message>
    <message>
        <source>E or W, or a number with its sign</source>
        <translation>E lub W albo liczba ze znakiem</translation>
    </message>
    <message>
        <source>the survey of %1 has the declination %2° (east +), the model %3°: what lies in the ground there is in no model; state the variation of the survey</source>
        <translation>pomiar kręgu %1 ma deklinację %2° (wschodnia +), model %3°: tego, co leży w ziemi, nie ma w żadnym modelu; podaj deklinację z pomiaru</translation>
    </message>
    <message>
        <source>the tracks do not tell the wind (three directions at one airspeed would): each knot of it across turns the track from the heading by %1°, into A, B and C; their errors allow for %2 kt of it</source>
        <translation>kąty drogi nie określają wiatru (określiłyby go trzy kierunki przy jednej prędkości powietrznej): każdy jego węzeł w poprzek odchyla kąt drogi od kursu o %1° i wchodzi w A, B i C; ich błędy dopuszczają %2 w</translation>
    </message>
    <message>
        <source>the log tells no time: its turn is taken as one of 1°/s</source>
        <translation>zapis nie podaje czasu: przyjęto obrót 1°/s</translation>
    </message>
    <message>
        <source>the turn goes one way at about one rate: A and a delay between heading and reference cannot be told apart, each second of delay is %1° of A; what is not known of it gives A a standard error of %2° (a turn the other way would tell)</source>
        <translation>obrót idzie w jedną stronę z mniej więcej jedną prędkością: A i opóźnienia między kursem a wzorcem nie da się rozróżnić, każda sekunda opóźnienia to %1° w A; to, czego o nim nie wiadomo, daje A błąd standardowy %2° (rozstrzygnąłby obrót w drugą stronę)</translation>
    </message>
    <message>
        <source>the headings are too uneven to tell the delay between heading and reference: each second of it is %1° of A</source>
        <translation>kursy są zbyt nierówne, by określić opóźnienie między kursem a wzorcem: każda jego sekunda to %1° w A</translation>
    </message>
    <message>
        <source>the headings stand on one side: %1</source>
        <translation>kursy leżą po jednej stronie: %1</translation>
    </message>
    <message>
        <source>%1 A, B, C, D and E cannot be told: %2</source>
        <translation>nie da się określić A, B, C, D i E (%1): %2</translation>
    </message>
    <message>
        <source>%1 D and E cannot be told: %2; whatever there is of them is hidden in A, B and C</source>
        <translation>nie da się określić D i E (%1): %2; ich udział kryje się w A, B i C</translation>
    </message>
    <message>
        <source>%1 D cannot be told: on the cardinal headings it does nothing</source>
        <translation>nie da się określić D (%1): na kursach głównych nie działa</translation>
    </message>
    <message>
        <source>%1 E cannot be told: on the intercardinal headings it does nothing</source>
        <translation>nie da się określić E (%1): na kursach pośrednich nie działa</translation>
    </message>
    <message>
        <source>%1 coefficients go through every reading: their standard errors are those of the reading alone, and no scatter can be seen</source>
        <translation>współczynniki (%1) przechodzą przez każdy odczyt: ich błędy standardowe wynikają z samego odczytu, a rozrzutu nie widać</translation>
    </message>
    <message>
        <source>%1 residuals of neighbouring readings are alike (correlation %2): the standard errors count that many readings tell little more than a few; something drifted slowly, or five coefficients do not describe the curve</source>
        <translation>reszty (%1) sąsiednich odczytów są podobne (korelacja %2): błędy standardowe uwzględniają, że wiele odczytów mówi niewiele więcej niż kilka; coś powoli dryfowało albo pięć współczynników nie opisuje krzywej</translation>
    </message>
    <message>
        <source>the compass reads %1 on all headings: it is stuck, or one figure was written down for all; no deviation can be told</source>
        <translation>busola wskazuje %1 na wszystkich kursach: zacięła się albo zapisano jedną wartość dla wszystkich; dewiacji nie da się określić</translation>
    </message>
    <message>
        <source>the compass runs backwards: it reads less as the aircraft turns right (a mirrored card, or headings and readings of opposite senses); no deviation can be told</source>
        <translation>busola obraca się wstecz: wskazuje mniej przy zakręcie w prawo (odwrócona róża albo kursy i odczyty o przeciwnych zwrotach); dewiacji nie da się określić</translation>
    </message>
    <message>
        <source>vertical soft iron (c, f) of about %1, hard iron (P, Q) of about %2 nT, compensating magnets of about %3 nT and a one-cycle error of the compass itself of about %4° (standard deviations)</source>
        <translation>pionowe żelazo miękkie (c, f) około %1, żelazo twarde (P, Q) około %2 nT, magnesy kompensujące około %3 nT i błąd półokrężny samej busoli około %4° (odchylenia standardowe)</translation>
    </message>
    <message>
        <source>five coefficients do not describe this curve: a third harmonic of %1° is in the readings, more than chance, and the card leaves it out (largest residual %2°)</source>
        <translation>pięć współczynników nie opisuje tej krzywej: odczyty zawierają trzecią harmoniczną %1°, więcej niż przypadek, a tablica dewiacji jej nie obejmuje (największa reszta %2°)</translation>
    </message>
    <message>
        <source>five coefficients leave a scatter of %1° where reading the compass explains %2°: the readings are poor, or more than five coefficients are in them</source>
        <translation>pięć współczynników pozostawia rozrzut %1°, a odczyt busoli tłumaczy %2°: odczyty są słabe albo zawierają więcej niż pięć współczynników</translation>
    </message>
    <message>
        <source>the dip is small at %1: vertical soft iron hardly showed, and what it does elsewhere is its assumed size only</source>
        <translation>inklinacja w %1 jest mała: pionowe żelazo miękkie prawie się nie ujawniło, a jego wpływ gdzie indziej wynika tylko z założonej wielkości</translation>
    </message>
    <message>
        <source>the readings of %1 leave nothing over to tell their errors by: an error of %2° a reading is assumed</source>
        <translation>odczyty pomiaru %1 nie pozostawiają nic do oceny błędów: przyjęto błąd %2° na odczyt</translation>
    </message>
    <message>
        <source>by the model</source>
        <translation>według modelu</translation>
    </message>
    <message>
        <source>with a probability of %1 %, assuming %2</source>
        <translation>z prawdopodobieństwem %1 %, przy założeniu: %2</translation>
    </message>
    <message>
        <source>one swing (%1), which cannot tell hard iron from vertical soft iron</source>
        <translation>jeden pomiar (%1), który nie odróżnia żelaza twardego od pionowego miękkiego</translation>
    </message>
    <message>
        <source>up to %1 is possible there, beyond the limit, %2</source>
        <translation>możliwe jest tam do %1, poza granicą, %2</translation>
    </message>
    <message>
        <source>the card of here may not be right there: the deviation changes by up to %1, %2</source>
        <translation>tutejsza tablica może tam nie obowiązywać: dewiacja zmienia się do %1, %2</translation>
    </message>
    <message>
        <source>the deviation changes by no more than %1, %2</source>
        <translation>dewiacja zmienia się najwyżej o %1, %2</translation>
    </message>
    <message>
        <source>adjuster and inspector are both %1; expected another person who checks the work</source>
        <translation>kompensował i sprawdza %1; oczekiwano innej osoby, która sprawdza pracę</translation>
    </message>
    <message>
        <source>%1 has signed as inspector or authority; expected another person as performer</source>
        <translation>%1 podpisał jako kontroler lub dopuszczający; oczekiwano innej osoby jako wykonawcy</translation>
    </message>
    <message>
        <source>%1 has signed as performer; expected another person who checks the work</source>
        <translation>%1 podpisał jako wykonawca; oczekiwano innej osoby, która sprawdza pracę</translation>
    </message>
    <message>
        <source>%1 adjusted this compass, as the swing says; expected another person who checks the work</source>
        <translation>według zapisu kompensował tę busolę %1; oczekiwano innej osoby, która sprawdza pracę</translation>
    </message>
    <message>
        <source>%1 inspects this swing, as it says; expected another person as performer</source>
        <translation>według zapisu pomiar sprawdza %1; oczekiwano innej osoby jako wykonawcy</translation>
    </message>
    <message>
        <source>no card: STEER does not rise with FOR: it is %2 for %1 and %4 for %3, so that one reading stands for more than one heading; expected a compass that rises all the way around</source>
        <translation>brak tablicy: STEER nie rośnie z FOR: wynosi %2 dla %1 i %4 dla %3, więc jeden odczyt oznacza więcej niż jeden kurs; oczekiwano busoli rosnącej w pełnym okręgu</translation>
    </message>
    <message>
        <source>no card: the magnetic heading does not rise with the compass&apos;s: it is %2 for %1 and %4 for %3; expected a compass that rises all the way around</source>
        <translation>brak tablicy: kurs magnetyczny nie rośnie z kursem kompasowym: wynosi %2 dla %1 i %4 dla %3; oczekiwano busoli rosnącej w pełnym okręgu</translation>
    </message>
    <message>
        <source>a card has steps of 10°, 15°, 30° or 45°, not %1°</source>
        <translation>tablica ma kroki 10°, 15°, 30° lub 45°, nie %1°</translation>
    </message>
    <message>
        <source>no card: while the aircraft turns from %1 to %2 (magnetic) the compass goes back from %3 to %4, so that one reading stands for more than one heading; expected a compass that rises all the way around</source>
        <translation>brak tablicy: gdy statek powietrzny obraca się od %1 do %2 (magnetycznie), busola cofa się od %3 do %4, więc jeden odczyt oznacza więcej niż jeden kurs; oczekiwano busoli rosnącej w pełnym okręgu</translation>
    </message>
    <message>
        <source>OVER THE LIMIT of %1 (%2): the spread of the deviation, %3</source>
        <translation>PONAD GRANICĘ %1 (%2): rozrzut dewiacji, %3</translation>
    </message>
    <message>
        <source>NOT LEVEL: swung at pitch %1, roll %2; these are not the figures of level flight</source>
        <translation>NIE W POZIOMIE: pomiar przy pochyleniu %1, przechyleniu %2; to nie są liczby lotu poziomego</translation>
    </message>
    <message>
        <source>SUSPECT reading used: on %1, %2 off the curve of the others</source>
        <translation>Użyto PODEJRZANEGO odczytu: na %1, %2 od krzywej pozostałych</translation>
    </message>
    <message>
        <source>nobody read near these rows: %1</source>
        <translation>w pobliżu tych wierszy nikt nie odczytał: %1</translation>
    </message>
    <message>
        <source>interpolating between rows is off by up to %1 (at %2): a card every %3 leaves %4</source>
        <translation>interpolacja między wierszami myli się do %1 (na %2): tablica co %3 pozostawia %4</translation>
    </message>
    <message>
        <source>interpolating between rows is off by up to %1 (at %2)</source>
        <translation>interpolacja między wierszami myli się do %1 (na %2)</translation>
    </message>
    <message>
        <source>the nearest reading to a row is up to %1 away</source>
        <translation>najbliższy odczyt leży do %1 od wiersza</translation>
    </message>
    <message>
        <source>how sure these figures are is not known: there are too few readings to tell</source>
        <translation>pewność tych liczb jest nieznana: odczytów jest za mało</translation>
    </message>
    <message>
        <source>no reading between %1 and %2 (compass), an arc of %3: how far the curve is off there is not known</source>
        <translation>brak odczytu między %1 a %2 (busola), łuk %3: nie wiadomo, jak bardzo krzywa się tam myli</translation>
    </message>
    <message>
        <source>no reading between %1 and %2 (compass), an arc of %3: the curve there is known to ±%4 only (95 %)</source>
        <translation>brak odczytu między %1 a %2 (busola), łuk %3: krzywa jest tam znana tylko do ±%4 (95 %)</translation>
    </message>
    <message>
        <source>the variation of the log is %1° (east +), that of %2 is %3°: they are %4° apart, and A with them; take the model&apos;s (variation: model) unless you know the log&apos;s to be right</source>
        <translation>deklinacja w zapisie wynosi %1° (wschodnia +), ta z %2 %3°: różnią się o %4°, a z nimi A; przyjmij deklinację modelu (variation: model), chyba że wiesz, że ta z zapisu jest dobra</translation>
    </message>
    <message>
        <source>the log is dated %1, a day on which the GPS week count began: the receiver did not know the date; state it</source>
        <translation>zapis ma datę %1, dzień początku liczenia tygodni GPS: odbiornik nie znał daty; podaj ją</translation>
    </message>
    <message>
        <source>the log is dated %1, and today is %2: one of the clocks is wrong</source>
        <translation>zapis ma datę %1, a dziś jest %2: jeden z zegarów jest błędny</translation>
    </message>
    <message>
        <source>the log is dated %1: a receiver that missed the turn of the GPS week count (1024 weeks) writes so for %2; state the date</source>
        <translation>zapis ma datę %1: odbiornik, który przeoczył przekręcenie licznika tygodni GPS (1024 tygodnie), pisze tak zamiast %2; podaj datę</translation>
    </message>
    <message>
        <source>the ground speed varies with the track, as if wind or current of %1 kt carried it: on wheels that is the driver; otherwise B and C are out by up to %2°; it can be taken out</source>
        <translation>prędkość względem ziemi zmienia się z kątem drogi, jakby niósł wiatr lub prąd %1 w: na kołach to kierowca; inaczej B i C są błędne nawet o %2°; można to odjąć</translation>
    </message>
    <message>
        <source>no pair of readings; expected both compasses read together</source>
        <translation>brak pary odczytów; oczekiwano obu busol odczytanych razem</translation>
    </message>
    <message>
        <source>no reading has a datum beside it: had both compasses moved alike, their readings would agree; that is not told apart from the datum</source>
        <translation>przy żadnym odczycie nie ma wzorca: gdyby obie busole przesunęły się tak samo, odczyty by się zgadzały; tego nie da się odróżnić</translation>
    </message>
    <message>
        <source>a compass without a swing on record has no card: what it always deviated counts as if it had moved</source>
        <translation>busola bez pomiaru w zapisach nie ma tablicy: jej stała dewiacja liczy się, jakby się przesunęła</translation>
    </message>
    <message>
        <source>not told which: the first has moved with %1 %, the second with %2 %, neither with %3 %; read them once beside a datum</source>
        <translation>nie wiadomo, która: pierwsza przesunęła się z %1 %, druga z %2 %, żadna z %3 %; odczytaj je raz przy wzorcu</translation>
    </message>
    <message>
        <source>the first compass moved (%1 %)</source>
        <translation>zmieniła się pierwsza busola (%1 %)</translation>
    </message>
    <message>
        <source>the second compass moved (%1 %)</source>
        <translation>zmieniła się druga busola (%1 %)</translation>
    </message>
    <message>
        <source>both compasses moved (%1 %)</source>
        <translation>zmieniły się obie busole (%1 %)</translation>
    </message>
    <message>
        <source>neither compass moved (%1 %)</source>
        <translation>nie zmieniła się żadna busola (%1 %)</translation>
    </message>
    <message>
        <source>no reading that counts; expected one at least, better two or three</source>
        <translation>brak liczącego się odczytu; oczekiwano co najmniej jednego, lepiej dwóch lub trzech</translation>
    </message>
    <message>
        <source>this compass has no swing on record: the check cannot know its card, and holds what was read against no deviation at all and the sizes that compasses of its kind have</source>
        <translation>ta busola nie ma pomiaru w zapisach: sprawdzenie nie zna jej tablicy i porównuje odczyty z brakiem dewiacji i z wielkościami, jakie mają busole tego rodzaju</translation>
    </message>
    <message>
        <source>even readings that agree with the card in full would leave a chance of %1 % that it does not hold: these headings are too few to clear this compass</source>
        <translation>nawet odczyty w pełni zgodne z tablicą zostawiłyby %1 % szansy, że nie jest ważna: tych kursów jest za mało, by uznać busolę za dobrą</translation>
    </message>
    <message>
        <source>swapped digits</source>
        <translation>zamienione cyfry</translation>
    </message>
    <message>
        <source>the reciprocal</source>
        <translation>kurs odwrotny</translation>
    </message>
    <message>
        <source>a 5° slip</source>
        <translation>pomyłka o 5°</translation>
    </message>
    <message>
        <source>a 10° slip</source>
        <translation>pomyłka o 10°</translation>
    </message>
    <message>
        <source>a 100° slip</source>
        <translation>pomyłka o 100°</translation>
    </message>
    <message>
        <source>a deviation applied with the wrong sign</source>
        <translation>dewiacja ze złym znakiem</translation>
    </message>
    <message>
        <source>the wrong row</source>
        <translation>zły wiersz</translation>
    </message>
    <message>
        <source>no usual slip</source>
        <translation>żadna typowa pomyłka</translation>
    </message>
    <message>
        <source>is binary: it has NUL bytes or lines of more than 1 MiB; expected %1</source>
        <translation>jest binarny: ma bajty NUL lub wiersze dłuższe niż 1 MiB; oczekiwano: %1</translation>
    </message>
    <message>
        <source>a quoted cell does not end in this row; expected figures and short texts</source>
        <translation>komórka w cudzysłowie nie kończy się w tym wierszu; oczekiwano liczb i krótkich tekstów</translation>
    </message>
    <message>
        <source>has no header; expected %1</source>
        <translation>nie ma nagłówka; oczekiwano: %1</translation>
    </message>
    <message>
        <source>the column %1 stands there twice; expected each once</source>
        <translation>kolumna %1 stoi tu dwa razy; każdej oczekiwano raz</translation>
    </message>
    <message>
        <source>the columns %1 and %2 say the same; expected one of them</source>
        <translation>kolumny %1 i %2 mówią to samo; oczekiwano jednej z nich</translation>
    </message>
    <message>
        <source>has %1 cells; expected the %2 of the header</source>
        <translation>ma komórek: %1; oczekiwano %2, jak w nagłówku</translation>
    </message>
    <message>
        <source>%1 %2 is no figure; expected a number, or nothing where it is missing</source>
        <translation>%1 %2 nie jest liczbą; oczekiwano liczby albo niczego, gdy jej brak</translation>
    </message>
    <message>
        <source>0 to 3000 knots</source>
        <translation>od 0 do 3000 węzłów</translation>
    </message>
    <message>
        <source>0 to 360</source>
        <translation>od 0 do 360</translation>
    </message>
    <message>
        <source>-90 to 90</source>
        <translation>od -90 do 90</translation>
    </message>
    <message>
        <source>-180 to 360</source>
        <translation>od -180 do 360</translation>
    </message>
    <message>
        <source>a Wind CSV: named columns, a report a row</source>
        <translation>plik Wind CSV: nazwane kolumny, meldunek w wierszu</translation>
    </message>
    <message>
        <source>has a header but no reports; expected one a row below it</source>
        <translation>ma nagłówek, lecz nie ma meldunków; oczekiwano pod nim jednego w wierszu</translation>
    </message>
    <message>
        <source>there is no reported wind; expected wind_speed_kt and wind_from_deg, or heading_deg and tas_kt</source>
        <translation>brak meldowanego wiatru; oczekiwano wind_speed_kt i wind_from_deg albo heading_deg i tas_kt</translation>
    </message>
    <message>
        <source>the column %1 means nothing here</source>
        <translation>kolumna %1 nic tu nie znaczy</translation>
    </message>
    <message>
        <source>there is no position with a time: the declination is not taken out, and the argument of the fit is the true heading</source>
        <translation>nie ma położenia z czasem: deklinacji nie odjęto, a argumentem dopasowania jest kurs rzeczywisty</translation>
    </message>
    <message>
        <source>time_utc %1 is no time; expected YYYY-MM-DDTHH:MM:SSZ</source>
        <translation>time_utc %1 nie jest czasem; oczekiwano RRRR-MM-DDTGG:MM:SSZ</translation>
    </message>
    <message>
        <source>a Wind CSV</source>
        <translation>plik Wind CSV</translation>
    </message>
    <message>
        <source>neither Scenario JSON nor a table of manoeuvres; expected { or from_s,to_s,turn_rate_deg_s,…</source>
        <translation>ani Scenario JSON, ani tabela manewrów; oczekiwano { lub from_s,to_s,turn_rate_deg_s,…</translation>
    </message>
    <message>
        <source>%1 stands inside a figure; expected it beside</source>
        <translation>%1 stoi wewnątrz liczby; oczekiwano go obok</translation>
    </message>
    <message>
        <source>%1 stands twice; expected it once</source>
        <translation>%1 stoi dwa razy; oczekiwano raz</translation>
    </message>
    <message>
        <source>a cell in quotes that does not end; expected names of columns</source>
        <translation>komórka w cudzysłowie, która się nie kończy; oczekiwano nazw kolumn</translation>
    </message>
    <message>
        <source>column %1 stands twice; expected it once</source>
        <translation>kolumna %1 stoi dwa razy; oczekiwano raz</translation>
    </message>
    <message>
        <source>column %1; expected from_s, to_s, turn_rate_deg_s, acceleration_m_s2 and climb_m_s</source>
        <translation>kolumna %1; oczekiwano from_s, to_s, turn_rate_deg_s, acceleration_m_s2 i climb_m_s</translation>
    </message>
    <message>
        <source>%1 cells and %2 columns; expected a cell a column</source>
        <translation>komórek %1, kolumn %2; oczekiwano jednej komórki na kolumnę</translation>
    </message>
    <message>
        <source>%1: %2 is no number</source>
        <translation>%1: %2 nie jest liczbą</translation>
    </message>
    <message>
        <source>%1 is missing; expected when the manoeuvre begins and ends</source>
        <translation>brak %1; oczekiwano, kiedy manewr się zaczyna i kończy</translation>
    </message>
    <message>
        <source>is %1; expected %2</source>
        <translation>wynosi %1; oczekiwano %2</translation>
    </message>
    <message>
        <source>says again what rms_m_s2 says; expected one of them</source>
        <translation>mówi jeszcze raz to, co rms_m_s2; oczekiwano jednego z nich</translation>
    </message>
    <message>
        <source>compass.model: %1</source>
        <translation>compass.model: %1</translation>
    </message>
    <message>
        <source>a Scenario JSON (a flight and its heading references)</source>
        <translation>plik Scenario JSON (lot i jego wzorce kursu)</translation>
    </message>
    <message>
        <source>a Scenario JSON or a table of manoeuvres</source>
        <translation>plik Scenario JSON albo tabela manewrów</translation>
    </message>
    <message>
        <source>no reference wind</source>
        <translation>brak wiatru odniesienia</translation>
    </message>
    <message>
        <source>no wind of its own, and no heading with airspeed</source>
        <translation>brak własnego wiatru oraz kursu z prędkością powietrzną</translation>
    </message>
    <message>
        <source>rolling</source>
        <translation>przechylenie</translation>
    </message>
    <message>
        <source>climbing or descending</source>
        <translation>wznoszenie lub zniżanie</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>zakręt</translation>
    </message>
    <message>
        <source>airspeed too low</source>
        <translation>za mała prędkość powietrzna</translation>
    </message>
    <message>
        <source>the same report again</source>
        <translation>ten sam meldunek jeszcze raz</translation>
    </message>
    <message>
        <source>no report can be used; %1 of %2 are left out for this: %3</source>
        <translation>żadnego meldunku nie można użyć; %1 z %2 pominięto z tego powodu: %3</translation>
    </message>
    <message>
        <source>the declination is not taken out of %1 of %2 reports (no position or no time): their argument is the true heading</source>
        <translation>deklinacji nie odjęto w %1 z %2 meldunków (brak położenia lub czasu): ich argumentem jest kurs rzeczywisty</translation>
    </message>
    <message>
        <source>%1; nothing is fitted until it is said which (winds from or towards, kt or m/s, or as the file says)</source>
        <translation>%1; nic nie jest dopasowane, dopóki nie wiadomo, co przyjąć (wiatr skąd czy dokąd, kt czy m/s, czy jak mówi plik)</translation>
    </message>
    <message>
        <source>the headings that were flown do not tell %1: no figure is given for it</source>
        <translation>przeleciane kursy nie określają %1: nie podano wartości</translation>
    </message>
    <message>
        <source>one flight only: what its reports share (an error of the reference wind) cannot be told from deviation, and nothing is held out</source>
        <translation>tylko jeden lot: tego, co jego meldunki mają wspólne (błąd wiatru odniesienia), nie da się odróżnić od dewiacji i nic nie odłożono do sprawdzenia</translation>
    </message>
    <message>
        <source>the headings that were flown do not tell D and E</source>
        <translation>przeleciane kursy nie określają D i E</translation>
    </message>
    <message>
        <source>the heading error follows the declination from place to place: the winds were made with magnetic headings that were taken as true</source>
        <translation>błąd kursu zmienia się z deklinacją z miejsca na miejsce: wiatry policzono z kursów magnetycznych wziętych za rzeczywiste</translation>
    </message>
    <message>
        <source>the offset, %1°, is the declination, %2°, the other way: the headings may be magnetic and taken as true</source>
        <translation>przesunięcie, %1°, jest deklinacją, %2°, z przeciwnym znakiem: kursy mogą być magnetyczne, wzięte za rzeczywiste</translation>
    </message>
    <message>
        <source>heading_deg is magnetic here, and not true: it agrees with the winds once the declination is added</source>
        <translation>heading_deg jest tu magnetyczny, a nie rzeczywisty: zgadza się z wiatrami po dodaniu deklinacji</translation>
    </message>
    <message>
        <source>too few aircraft to bound what they have in common: a constant error of the reference wind of 1 kt looks like %1° of B or C and is not told apart</source>
        <translation>za mało statków powietrznych, by ograniczyć to, co wspólne: stały błąd wiatru odniesienia 1 w wygląda jak %1° w B lub C i nie daje się odróżnić</translation>
    </message>
    <message>
        <source>the reported winds are not what their column says</source>
        <translation>meldowane wiatry nie są tym, co mówi ich kolumna</translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as blowing towards the direction given, and not from it</source>
        <translation>meldowane wiatry pasują, gdy wziąć je jako wiejące ku podanemu kierunkowi, a nie z niego</translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as m/s, and not as knots</source>
        <translation>meldowane wiatry pasują, gdy wziąć je w m/s, a nie w węzłach</translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as m/s and as blowing towards the direction given</source>
        <translation>meldowane wiatry pasują, gdy wziąć je w m/s i jako wiejące ku podanemu kierunkowi</translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as twice too large (knots that were converted twice)</source>
        <translation>meldowane wiatry pasują, gdy wziąć je za dwukrotnie za duże (węzły przeliczone dwa razy)</translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as twice too large and as blowing towards the direction given</source>
        <translation>meldowane wiatry pasują, gdy wziąć je za dwukrotnie za duże i wiejące ku podanemu kierunkowi</translation>
    </message>
    <message>
        <source>the reference winds are not what their column says</source>
        <translation>wiatry odniesienia nie są tym, co mówi ich kolumna</translation>
    </message>
    <message>
        <source>reported and reference winds blow against each other: one of them is given as blowing towards, and not from</source>
        <translation>wiatry meldowane i odniesienia wieją przeciw sobie: jedne z nich podano jako „dokąd”, a nie „skąd”</translation>
    </message>
    <message>
        <source>the reported winds are half of the reference winds: one of them is in m/s, and not in knots</source>
        <translation>wiatry meldowane są połową wiatrów odniesienia: jedne z nich są w m/s, a nie w węzłach</translation>
    </message>
    <message>
        <source>reported and reference winds are in two units and blow against each other</source>
        <translation>wiatry meldowane i odniesienia są w dwóch jednostkach i wieją przeciw sobie</translation>
    </message>
    <message>
        <source>the reference winds are half of the reported winds: one of them is in m/s, and not in knots</source>
        <translation>wiatry odniesienia są połową meldowanych: jedne z nich są w m/s, a nie w węzłach</translation>
    </message>
    <message>
        <source>airspeeds are far more even when both winds are taken as blowing towards the directions given, and not from them</source>
        <translation>prędkości powietrzne są znacznie równiejsze, gdy oba wiatry wziąć jako wiejące ku podanym kierunkom, a nie z nich</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>nastawienie</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>odczytu</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>dryf</translation>
    </message>
    <message>
        <source>published direction</source>
        <translation>ogłoszony kierunek</translation>
    </message>
    <message>
        <source>lining up</source>
        <translation>ustawienie w osi</translation>
    </message>
    <message>
        <source>one-cycle error</source>
        <translation>błąd półokrężny</translation>
    </message>
    <message>
        <source>two-cycle error</source>
        <translation>błąd ćwierćokrężny</translation>
    </message>
    <message>
        <source>the levelling loop is unstable: third order needs tau3 &gt; tau2, and tau3 is %1 s with tau2 %2 s</source>
        <translation>pętla poziomowania jest niestabilna: trzeci rząd wymaga tau3 &gt; tau2, a tau3 wynosi %1 s przy tau2 %2 s</translation>
    </message>
    <message>
        <source>the speed of %1 m/s is beyond an aircraft&apos;s</source>
        <translation>prędkość %1 m/s jest poza możliwościami statku powietrznego</translation>
    </message>
    <message>
        <source>the turn of %1°/s is beyond an aircraft&apos;s</source>
        <translation>zakręt %1°/s jest poza możliwościami statku powietrznego</translation>
    </message>
    <message>
        <source>an acceleration of %1 g is beyond an aircraft&apos;s</source>
        <translation>przyspieszenie %1 g jest poza możliwościami statku powietrznego</translation>
    </message>
    <message>
        <source>so near to a pole every track crosses meridians at once: what goes with tan of the latitude is left out; steer by grid</source>
        <translation>tak blisko bieguna każda droga od razu przecina południki: to, co rośnie z tangensem szerokości, pominięto; leć według siatki</translation>
    </message>
    <message>
        <source>the aircraft is slowed below standing still; it stays at 0 m/s</source>
        <translation>statek powietrzny zwalnia poniżej zera; pozostaje przy 0 m/s</translation>
    </message>
    <message>
        <source>no horizontal field is left at the sensor at times: what it read before is held there</source>
        <translation>chwilami przy czujniku nie zostaje pole poziome: utrzymano tam poprzednie wskazanie</translation>
    </message>
    <message>
        <source>%1 is %2; expected more than 0</source>
        <translation>%1 wynosi %2; oczekiwano więcej niż 0</translation>
    </message>
    <message>
        <source>the levelling time constant (tau1_s)</source>
        <translation>stała czasowa poziomowania (tau1_s)</translation>
    </message>
    <message>
        <source>the damping time constant (tau2_s)</source>
        <translation>stała czasowa tłumienia (tau2_s)</translation>
    </message>
    <message>
        <source>the integral time constant (tau3_s)</source>
        <translation>stała czasowa całkowania (tau3_s)</translation>
    </message>
    <message>
        <source>the levelling rate limit</source>
        <translation>ograniczenie prędkości poziomowania</translation>
    </message>
    <message>
        <source>the cut-off</source>
        <translation>próg odcięcia</translation>
    </message>
    <message>
        <source>the time constant of fast levelling</source>
        <translation>stała czasowa szybkiego poziomowania</translation>
    </message>
    <message>
        <source>the slaving time constant</source>
        <translation>stała czasowa korekcji magnetycznej</translation>
    </message>
    <message>
        <source>the slaving rate</source>
        <translation>prędkość korekcji magnetycznej</translation>
    </message>
    <message>
        <source>the fast slaving rate</source>
        <translation>prędkość szybkiej korekcji magnetycznej</translation>
    </message>
    <message>
        <source>the step</source>
        <translation>krok</translation>
    </message>
    <message>
        <source>the duration is negative; expected 0 s or more</source>
        <translation>czas trwania jest ujemny; oczekiwano 0 s lub więcej</translation>
    </message>
    <message>
        <source>%1 s in steps of %2 s are more than 2000000 steps; expected a wider step</source>
        <translation>%1 s w krokach po %2 s to więcej niż 2000000 kroków; oczekiwano większego kroku</translation>
    </message>
    <message>
        <source>a manoeuvre from %1 s to %2 s ends before it begins; expected to_s after from_s</source>
        <translation>manewr od %1 s do %2 s kończy się, zanim się zacznie; oczekiwano to_s po from_s</translation>
    </message>
    <message>
        <source>the period of the gusts</source>
        <translation>okres podmuchów</translation>
    </message>
    <message>
        <source>the period of the card</source>
        <translation>okres róży</translation>
    </message>
    <message>
        <source>the compass&apos;s model stands in no horizontal field; expected its field with H above 0</source>
        <translation>model busoli stoi bez pola poziomego; oczekiwano jej pola z H większym od 0</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>zegar</translation>
    </message>
    <message>
        <source>position</source>
        <translation>położenie</translation>
    </message>
    <message>
        <source>plumb</source>
        <translation>pion</translation>
    </message>
    <message>
        <source>pointing</source>
        <translation>celowanie</translation>
    </message>
    <message>
        <source>the sun is %1° below the horizon: it throws no shadow</source>
        <translation>słońce jest %1° pod horyzontem: nie rzuca cienia</translation>
    </message>
    <message>
        <source>the sun stands %1° high: its azimuth tells little (±%2°, one standard deviation); wait until it is lower</source>
        <translation>słońce stoi na wysokości %1°: jego azymut mówi niewiele (±%2°, jedno odchylenie standardowe); poczekaj, aż będzie niżej</translation>
    </message>
    <message>
        <source>the sun stands %1° high: shadows are %2 times as long as the pin, and faint</source>
        <translation>słońce stoi na wysokości %1°: cienie są %2 razy dłuższe od pręta i słabe</translation>
    </message>
    <message>
        <source>the sun&apos;s place is held against almanacs from 1950 to 2050 only</source>
        <translation>położenie słońca sprawdzono z almanachami tylko od 1950 do 2050</translation>
    </message>
    <message>
        <source>%1 is no time; expected YYYY-MM-DDTHH:MM:SSZ</source>
        <translation>%1 nie jest czasem; oczekiwano RRRR-MM-DDTGG:MM:SSZ</translation>
    </message>
    <message>
        <source>%1 does not say which clock it is of; expected Z (UTC) or an offset as +02:00 behind it</source>
        <translation>%1 nie mówi, jaki to zegar; oczekiwano za nim Z (UTC) lub przesunięcia, np. +02:00</translation>
    </message>
    <message>
        <source>a table of variation has steps of 0.1° to 30°</source>
        <translation>tabela deklinacji ma kroki od 0.1° do 30°</translation>
    </message>
    <message>
        <source>the vertical gyro tumbles: it is at its stop, 90° from the vertical, from %1 s</source>
        <translation>żyroskop pionu przewraca się: od %1 s stoi na ograniczniku, 90° od pionu</translation>
    </message>
    <message>
        <source>the apparent vertical leans by up to %1°, and the book&apos;s a/g takes it for %2°; exact_tilt takes the angle itself</source>
        <translation>pozorny pion odchyla się do %1°, a wzór a/g z książki bierze to za %2°; exact_tilt bierze sam kąt</translation>
    </message>
    <message>
        <source>heading, pitch and roll look like radians: the largest heading is %1, and as radians they explain the samples far better; expected degrees</source>
        <translation>kurs, pochylenie i przechylenie wyglądają na radiany: największy kurs to %1, a jako radiany znacznie lepiej wyjaśniają próbki; oczekiwano stopni</translation>
    </message>
    <message>
        <source>pitch and roll look like radians: they stay within %1, and as radians they explain the samples far better; expected degrees</source>
        <translation>pochylenie i przechylenie wyglądają na radiany: mieszczą się w %1, a jako radiany znacznie lepiej wyjaśniają próbki; oczekiwano stopni</translation>
    </message>
    <message>
        <source>%1 cannot be told: the field along %2 is never other than 0 in this log</source>
        <translation>nie da się określić %1: pole wzdłuż %2 w tym zapisie zawsze wynosi 0</translation>
    </message>
    <message>
        <source>%1 cannot be told: the current is never other than 0 in this log</source>
        <translation>nie da się określić %1: prąd w tym zapisie zawsze wynosi 0</translation>
    </message>
    <message>
        <source>%1 cannot be told apart, as the field along %2 is always the same: only %3 is known</source>
        <translation>nie da się rozróżnić %1, bo pole wzdłuż %2 jest zawsze takie samo: znane jest tylko %3</translation>
    </message>
    <message>
        <source>%1 cannot be told apart: in this log what they do always goes together</source>
        <translation>nie da się rozróżnić %1: w tym zapisie ich działanie zawsze występuje razem</translation>
    </message>
    <message>
        <source>the axes of the log are not those of the aircraft: %1 fits %2 times better; expected x forward, y starboard, z down</source>
        <translation>osie zapisu nie są osiami statku powietrznego: %1 pasuje %2 razy lepiej; oczekiwano x do przodu, y w prawo, z w dół</translation>
    </message>
    <message>
        <source>the headings look true instead of magnetic: with the place&apos;s variation (%1°) taken out they explain the samples far better; expected magnetic headings</source>
        <translation>kursy wyglądają na rzeczywiste zamiast magnetycznych: po odjęciu deklinacji miejsca (%1°) znacznie lepiej wyjaśniają próbki; oczekiwano kursów magnetycznych</translation>
    </message>
    <message>
        <source>the standard error of the hard iron is %1 nT; expected %2 nT or less, and nothing is determined above %3 nT</source>
        <translation>błąd standardowy żelaza twardego wynosi %1 nT; oczekiwano najwyżej %2 nT, a powyżej %3 nT nic nie jest określone</translation>
    </message>
    <message>
        <source>the standard error of the hard iron is %1 nT; expected %2 nT or less</source>
        <translation>błąd standardowy żelaza twardego wynosi %1 nT; oczekiwano najwyżej %2 nT</translation>
    </message>
    <message>
        <source>%1 of %2 parameters can be told; what cannot is named</source>
        <translation>da się określić %1 z %2 parametrów; pozostałe są wymienione</translation>
    </message>
    <message>
        <source>log all headings at more than one pitch and roll: 20° either way tells all, 5° tells a quarter as well</source>
        <translation>zapisz wszystkie kursy przy więcej niż jednym pochyleniu i przechyleniu: 20° w obie strony określa wszystko, 5° cztery razy słabiej</translation>
    </message>
    <message>
        <source>headings that were held out are off by %1° rms; expected %2° or less</source>
        <translation>kursy odłożone do sprawdzenia różnią się o %1° (średnia kwadratowa); oczekiwano najwyżej %2°</translation>
    </message>
    <message>
        <source>the sensor seems turned by %1°, which is the variation of the place (%2°): are the headings true instead of magnetic?</source>
        <translation>czujnik wydaje się obrócony o %1°, a tyle wynosi deklinacja miejsca (%2°): czy kursy są rzeczywiste zamiast magnetycznych?</translation>
    </message>
    <message>
        <source>has no attitude; expected the columns heading_deg, pitch_deg and roll_deg</source>
        <translation>nie ma położenia kątowego; oczekiwano kolumn heading_deg, pitch_deg i roll_deg</translation>
    </message>
    <message>
        <source>is in counts; expected a log in nT, uT, mG or G, as the field that it is held against is</source>
        <translation>jest w zliczeniach; oczekiwano zapisu w nT, uT, mG lub G, jak pole, z którym się go porównuje</translation>
    </message>
    <message>
        <source>has %1 usable samples; expected %2 or more</source>
        <translation>ma użytecznych próbek: %1; oczekiwano %2 lub więcej</translation>
    </message>
    <message>
        <source>soft constants D1, D2, D3 and hard iron P, Q, R add up: one survey in one field tells their sum, which stands as P, Q, R</source>
        <translation>stałe miękkie D1, D2, D3 i żelazo twarde P, Q, R sumują się: jeden pomiar w jednym polu określa ich sumę, podaną jako P, Q, R</translation>
    </message>
    <message>
        <source>a turn of the sensor in its mount and the unsymmetric part of soft iron are one thing: the misalignment is stated for symmetric soft iron</source>
        <translation>obrót czujnika w mocowaniu i niesymetryczna część żelaza miękkiego to jedno: niewspółosiowość podano dla symetrycznego żelaza miękkiego</translation>
    </message>
    <message>
        <source>attitude is taken for exact; an error of 1° makes some 420 nT in R: state it (standard deviation), and it is taken out</source>
        <translation>położenie kątowe przyjęto za dokładne; błąd 1° daje w R około 420 nT: podaj go (odchylenie standardowe), a zostanie odjęty</translation>
    </message>
    <message>
        <source>an attitude error of %1° is taken out of the moments; what is not known of it by a tenth leaves a fifth of its bias</source>
        <translation>błąd położenia kątowego %1° odjęto od momentów; nieznajomość jego dziesiątej części zostawia piątą część jego obciążenia</translation>
    </message>
    <message>
        <source>has no applied field; expected the columns ax_nT, ay_nT, az_nT beside bx_nT, by_nT, bz_nT</source>
        <translation>nie ma pola przyłożonego; oczekiwano kolumn ax_nT, ay_nT, az_nT obok bx_nT, by_nT, bz_nT</translation>
    </message>
    <message>
        <source>has %1 whole rows; expected 8 or more</source>
        <translation>ma pełnych wierszy: %1; oczekiwano 8 lub więcej</translation>
    </message>
    <message>
        <source>an odd number of the sensor&apos;s axes runs against the coil&apos;s: its frame is left-handed, and no rotation describes its mount</source>
        <translation>nieparzysta liczba osi czujnika biegnie przeciw cewce: jego układ jest lewoskrętny i żaden obrót nie opisuje mocowania</translation>
    </message>
    <message>
        <source>the applied field does not go through all three axes by itself (and temperature, where there is one); expected steps along x, y and z</source>
        <translation>pole przyłożone nie przechodzi osobno przez wszystkie trzy osie (i temperaturę, jeśli jest); oczekiwano kroków wzdłuż x, y i z</translation>
    </message>
    <message>
        <source>the applied field went to %1 nT only: beyond it nothing is known of the sensor (a field of the Earth with an aircraft&apos;s iron reaches 65 000 nT and more)</source>
        <translation>pole przyłożone sięgało tylko %1 nT: powyżej nic o czujniku nie wiadomo (pole Ziemi z żelazem statku powietrznego dochodzi do 65 000 nT i więcej)</translation>
    </message>
    <message>
        <source>the measured field is in counts: scale is counts per nT, and bias, noise and the rest are in counts</source>
        <translation>pole zmierzone jest w zliczeniach: skala to zliczenia na nT, a przesunięcie, szum i reszta są w zliczeniach</translation>
    </message>
    <message>
        <source>the field&apos;s size spreads by %1 %3 with the model and by %2 %3 without: a log of another sensor, or of another mount?</source>
        <translation>wielkość pola rozrzuca się o %1 %3 z modelem i o %2 %3 bez niego: zapis innego czujnika albo innego mocowania?</translation>
    </message>
    <message>
        <source>the field&apos;s size is %1 nT with the model, %2 % off the model&apos;s %3 nT: a log of another sensor, unit or place?</source>
        <translation>wielkość pola z modelem wynosi %1 nT, %2 % inaczej niż %3 nT modelu: zapis innego czujnika, jednostki lub miejsca?</translation>
    </message>
    <message>
        <source>holds no usable sample</source>
        <translation>nie zawiera użytecznej próbki</translation>
    </message>
    <message>
        <source>without pitch and roll the headings are those of a level compass</source>
        <translation>bez pochylenia i przechylenia kursy są kursami busoli poziomej</translation>
    </message>
    <message>
        <source>samples a second</source>
        <translation>próbek na sekundę</translation>
    </message>
    <message>
        <source>latency of the sensor and the filter</source>
        <translation>opóźnienie czujnika i filtru</translation>
    </message>
    <message>
        <source>heading error, rms</source>
        <translation>błąd kursu, średni kwadratowy</translation>
    </message>
    <message>
        <source>the nose</source>
        <translation>nos</translation>
    </message>
    <message>
        <source>the starboard (right) side</source>
        <translation>prawy bok</translation>
    </message>
    <message>
        <source>the belly</source>
        <translation>spód</translation>
    </message>
    <message>
        <source>the tail</source>
        <translation>ogon</translation>
    </message>
    <message>
        <source>the port (left) side</source>
        <translation>lewy bok</translation>
    </message>
    <message>
        <source>the roof</source>
        <translation>grzbiet</translation>
    </message>
    <message>
        <source>the edge between %1 and %2</source>
        <translation>krawędź między %1 a %2</translation>
    </message>
    <message>
        <source>the corner between %1, %2 and %3</source>
        <translation>narożnik między %1, %2 i %3</translation>
    </message>
    <message>
        <source>point %1 along the Earth&apos;s field (towards north, and down in the northern hemisphere)</source>
        <translation>skieruj %1 wzdłuż pola Ziemi (na północ, a na półkuli północnej w dół)</translation>
    </message>
    <message>
        <source>%1 readings; expected %2 or more: a place, a moment and a uniform field are nine unknown figures</source>
        <translation>odczytów: %1; oczekiwano %2 lub więcej: położenie, moment i pole jednorodne to dziewięć niewiadomych</translation>
    </message>
    <message>
        <source>readings %1 and %2 are at one place; expected each somewhere else</source>
        <translation>odczyty %1 i %2 są w jednym miejscu; każdego oczekiwano gdzie indziej</translation>
    </message>
    <message>
        <source>no dipole explains the readings: the field hardly changes from place to place, or there is more than one source</source>
        <translation>żaden dipol nie wyjaśnia odczytów: pole prawie nie zmienia się z miejsca na miejsce albo źródeł jest więcej</translation>
    </message>
    <message>
        <source>the nearest reading is %1 m from the source, less than three of its lengths (%2 m): it is no dipole there</source>
        <translation>najbliższy odczyt jest %1 m od źródła, bliżej niż trzy jego długości (%2 m): tam nie jest ono dipolem</translation>
    </message>
    <message>
        <source>the place is sure to %1 m only: read nearer to it, and on more sides</source>
        <translation>położenie jest pewne tylko do %1 m: odczytaj bliżej i z większej liczby stron</translation>
    </message>
    <message>
        <source>electric motors and relays, magnets, loudspeakers</source>
        <translation>silniki elektryczne i przekaźniki, magnesy, głośniki</translation>
    </message>
    <message>
        <source>ferrous parts of more than 1 kg</source>
        <translation>części żelazne powyżej 1 kg</translation>
    </message>
    <message>
        <source>ferrous parts of less than 1 kg</source>
        <translation>części żelazne poniżej 1 kg</translation>
    </message>
    <message>
        <source>wires of more than 100 mA</source>
        <translation>przewody powyżej 100 mA</translation>
    </message>
    <message>
        <source>wires of less than 100 mA</source>
        <translation>przewody poniżej 100 mA</translation>
    </message>
    <message>
        <source>another flux gate</source>
        <translation>inny czujnik indukcyjny</translation>
    </message>
    <message>
        <source>all samples are equal: the sensor was not turned, or it is stuck</source>
        <translation>wszystkie próbki są równe: czujnika nie obracano albo się zaciął</translation>
    </message>
    <message>
        <source>the samples lie on a line: across it they spread by %1 %3 against %2 %3 along it; expected %4 %3 or more</source>
        <translation>próbki leżą na prostej: w poprzek rozrzucone są o %1 %3 wobec %2 %3 wzdłuż niej; oczekiwano %4 %3 lub więcej</translation>
    </message>
    <message>
        <source>the samples lie in a plane: off it they spread by %1 %3 against %2 %3 in it; expected %4 %3 or more</source>
        <translation>próbki leżą w płaszczyźnie: poza nią rozrzucone są o %1 %3 wobec %2 %3 w niej; oczekiwano %4 %3 lub więcej</translation>
    </message>
    <message>
        <source>no samples within %1° of one direction: %2</source>
        <translation>brak próbek w promieniu %1° od jednego kierunku: %2</translation>
    </message>
    <message>
        <source>the gate (condition × noise/field) is %1; expected %2 or less, and nothing is determined above %3</source>
        <translation>próg (uwarunkowanie × szum/pole) wynosi %1; oczekiwano najwyżej %2, a powyżej %3 nic nie jest określone</translation>
    </message>
    <message>
        <source>the field&apos;s size is off by %1 % (rms) after calibration; expected %2 % or less: it was not the same everywhere, or the sensor&apos;s scale is not of this shape</source>
        <translation>wielkość pola po kalibracji różni się o %1 % (średnia kwadratowa); oczekiwano najwyżej %2 %: nie była wszędzie taka sama albo skala czujnika ma inny kształt</translation>
    </message>
    <message>
        <source>log again away from iron, cars and cables</source>
        <translation>zapisz jeszcze raz z dala od żelaza, samochodów i kabli</translation>
    </message>
    <message>
        <source>%1 of %2 samples were left out as spikes or faults; expected one in five or fewer</source>
        <translation>%1 z %2 próbek pominięto jako szpilki lub usterki; oczekiwano najwyżej jednej na pięć</translation>
    </message>
    <message>
        <source>the log is in counts: the field that was given is not used, and the radius is in counts</source>
        <translation>zapis jest w zliczeniach: podanego pola nie użyto, a promień jest w zliczeniach</translation>
    </message>
    <message>
        <source>turn the sensor through all attitudes, each side up once, with a full turn in each</source>
        <translation>obróć czujnik przez wszystkie położenia, każdym bokiem raz do góry, z pełnym obrotem w każdym</translation>
    </message>
    <message>
        <source>no ellipsoid goes through the samples: too few attitudes, or a field that was not the same everywhere</source>
        <translation>przez próbki nie przechodzi żadna elipsoida: za mało położeń albo pole nie było wszędzie takie samo</translation>
    </message>
    <message>
        <source>the currents changed together only: their fields per ampere cannot be told apart</source>
        <translation>prądy zmieniały się tylko razem: ich pól na amper nie da się rozróżnić</translation>
    </message>
    <message>
        <source>has no time; expected a column time_s</source>
        <translation>nie ma czasu; oczekiwano kolumny time_s</translation>
    </message>
    <message>
        <source>is in counts; expected a log in nT, uT, mG or G, as the limits are in nT</source>
        <translation>jest w zliczeniach; oczekiwano zapisu w nT, uT, mG lub G, bo granice są w nT</translation>
    </message>
    <message>
        <source>%1 at %2 s has %3 samples before and %4 after it; expected %5 or more of each: actions inside the log, and time between them</source>
        <translation>%1 w %2 s ma przed sobą próbek %3, a po sobie %4; oczekiwano %5 lub więcej: czynności wewnątrz zapisu i czasu między nimi</translation>
    </message>
    <message>
        <source>there are no actions; expected at least one</source>
        <translation>nie ma czynności; oczekiwano co najmniej jednej</translation>
    </message>
    <message>
        <source>the noise of axis %1 is %2 nT: with a limit of %3 nT the test may fail by noise alone</source>
        <translation>szum osi %1 wynosi %2 nT: przy granicy %3 nT próba może wypaść źle przez sam szum</translation>
    </message>
    <message>
        <source>axis %1 is stuck in %2 of %3 samples: its figure stands while another axis moves; look at its cable and its column</source>
        <translation>oś %1 stoi w %2 z %3 próbek: jej wartość się nie zmienia, gdy inna oś się rusza; sprawdź jej kabel i jej kolumnę</translation>
    </message>
    <message>
        <source>%1 of %2 samples have no whole field: empty cells, or NaN</source>
        <translation>%1 z %2 próbek nie ma pełnego pola: puste komórki lub NaN</translation>
    </message>
    <message>
        <source>%1 of %2 samples are cut off: the field is beyond the sensor&apos;s range</source>
        <translation>%1 z %2 próbek jest obciętych: pole przekracza zakres czujnika</translation>
    </message>
    <message>
        <source>%1 of %2 samples are spikes</source>
        <translation>%1 z %2 próbek to szpilki</translation>
    </message>
    <message>
        <source>the model&apos;s soft iron cannot be taken out: 1 + S has no inverse</source>
        <translation>nie da się odjąć żelaza miękkiego modelu: 1 + S nie ma odwrotności</translation>
    </message>
    <message>
        <source>heading_deg is what this compass itself reads%1, to %2° in every row: it cannot show its own deviation; expected a reference of its own (inertial, GPS, datum compass)</source>
        <translation>heading_deg to wskazanie samej tej busoli%1, do %2° w każdym wierszu: nie może pokazać własnej dewiacji; oczekiwano osobnego wzorca (inercyjnego, GPS, busoli wzorcowej)</translation>
    </message>
    <message>
        <source>mains 50 Hz</source>
        <translation>sieć 50 Hz</translation>
    </message>
    <message>
        <source>mains 60 Hz</source>
        <translation>sieć 60 Hz</translation>
    </message>
    <message>
        <source>aircraft supply 400 Hz</source>
        <translation>zasilanie pokładowe 400 Hz</translation>
    </message>
    <message>
        <source>115 Hz</source>
        <translation>115 Hz</translation>
    </message>
    <message>
        <source>harmonic %1 of %2</source>
        <translation>harmoniczna %1 z %2</translation>
    </message>
    <message>
        <source>rotor order %1</source>
        <translation>rząd wirnika %1</translation>
    </message>
    <message>
        <source>has no stretch of %1 samples without a gap; expected at least one segment</source>
        <translation>nie ma odcinka %1 próbek bez przerwy; oczekiwano co najmniej jednego</translation>
    </message>
    <message>
        <source>at %1 samples a second %2 Hz fall on 0 Hz: the field of such a supply would look like hard iron; calibrate with it off, or log at another rate</source>
        <translation>przy %1 próbkach na sekundę %2 Hz pada na 0 Hz: pole takiego zasilania wyglądałoby jak żelazo twarde; kalibruj przy wyłączonym albo zapisuj z inną częstością</translation>
    </message>
    <message>
        <source>has no time; expected a column time_s that goes on</source>
        <translation>nie ma czasu; oczekiwano kolumny time_s, w której czas płynie</translation>
    </message>
    <message>
        <source>has no such column</source>
        <translation>nie ma takiej kolumny</translation>
    </message>
    <message>
        <source>has no column %1</source>
        <translation>nie ma kolumny %1</translation>
    </message>
    <message>
        <source>the line at %1 Hz may be %2 Hz, folded down by sampling: a filter behind the sensor cannot tell it from what is there</source>
        <translation>linia %1 Hz może być %2 Hz odbitą przez próbkowanie: filtr za czujnikiem nie odróżni jej od tego, co tam jest</translation>
    </message>
    <message>
        <source>%1 ms are less than one sample of this log (%2 ms): such a filter runs in the sensor, not behind it</source>
        <translation>%1 ms to mniej niż jedna próbka tego zapisu (%2 ms): taki filtr działa w czujniku, nie za nim</translation>
    </message>
    <message>
        <source>read beside %1, the compass %2 no longer holds its card (%3 %)</source>
        <translation>odczytana obok %1 busola %2 nie zgadza się już ze swoją tablicą (%3 %)</translation>
    </message>
    <message>
        <source>read together, neither %1 nor %2 holds its card (%3 %)</source>
        <translation>odczytane razem, ani %1, ani %2 nie zgadza się ze swoją tablicą (%3 %)</translation>
    </message>
    <message>
        <source>read together, one of %1 and %2 no longer holds its card, not told which (%3 %)</source>
        <translation>odczytane razem, jedna z %1 i %2 nie zgadza się już ze swoją tablicą, nie wiadomo która (%3 %)</translation>
    </message>
    <message>
        <source>the card holds within %1° on all headings; this is wrong with a probability of %2 %</source>
        <translation>tablica jest ważna w granicach %1° na wszystkich kursach; prawdopodobieństwo pomyłki: %2 %</translation>
    </message>
    <message>
        <source>swing it: with a probability of %1 % the card does not hold within %2° any more; this is wrong with %3 %</source>
        <translation>wykonaj pomiar dewiacji: z prawdopodobieństwem %1 % tablica nie jest już ważna w granicach %2°; prawdopodobieństwo pomyłki: %3 %</translation>
    </message>
    <message>
        <source>%1 readings clockwise and %2 counter-clockwise; expected %3 or more of each</source>
        <translation>odczytów w prawo %1, w lewo %2; oczekiwano %3 lub więcej w każdą stronę</translation>
    </message>
    <message>
        <source>the headings of both runs do not tell what differs between them; expected them all around</source>
        <translation>kursy obu przebiegów nie określają, co je różni; oczekiwano kursów dookoła</translation>
    </message>
    <message>
        <source>the runs differ by %1° on all headings: something is late (card, liquid, reference); turn slower, 0.2 to 3 degrees a second</source>
        <translation>przebiegi różnią się o %1° na wszystkich kursach: coś się opóźnia (róża, ciecz, wzorzec); obracaj wolniej, od 0.2 do 3 stopni na sekundę</translation>
    </message>
    <message>
        <source>the runs differ by up to %1° once around: iron keeps a trace of the heading before, or the field of the site is not the same on both tracks</source>
        <translation>przebiegi różnią się do %1° raz na obrót: żelazo zachowuje ślad poprzedniego kursu albo pole miejsca nie jest takie samo na obu torach</translation>
    </message>
    <message>
        <source>both runs tell the same</source>
        <translation>oba przebiegi mówią to samo</translation>
    </message>
    <message>
        <source>OUT OF LIMITS by the swing of %1</source>
        <translation>POZA GRANICAMI według pomiaru z %1</translation>
    </message>
    <message>
        <source>OUT OF LIMITS by the swing of %1: up to %2°, %3° is allowed%4</source>
        <translation>POZA GRANICAMI według pomiaru z %1: do %2°, dopuszczalne %3°%4</translation>
    </message>
    <message>
        <source>over 99 % likely out of limits by %1: %2</source>
        <translation>z ponad 99 % prawdopodobieństwem poza granicami do %1: %2</translation>
    </message>
    <message>
        <source>%1 % likely out of limits by %2: %3</source>
        <translation>z prawdopodobieństwem %1 % poza granicami do %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2: D is %3° in %4 of %5 swings (%6 to %7) where its siblings have %8°: the sign of these records is suspect; nothing was turned</source>
        <translation>%1 · %2: D wynosi %3° w %4 z %5 pomiarów (od %6 do %7), gdzie siostrzane mają %8°: znak tych zapisów jest podejrzany; niczego nie odwrócono</translation>
    </message>
    <message>
        <source>%1 %2° ± %3° from %4 aircraft; the next one within %5° to %6° (95 %)</source>
        <translation>%1 %2° ± %3° z %4 statków powietrznych; następny między %5° a %6° (95 %)</translation>
    </message>
    <message>
        <source>expected a CSV with the columns time_s and action</source>
        <translation>oczekiwano pliku CSV z kolumnami time_s i action</translation>
    </message>
    <message>
        <source>cannot be read as text; %1</source>
        <translation>nie daje się odczytać jako tekst; %1</translation>
    </message>
    <message>
        <source>has no such header; %1</source>
        <translation>nie ma takiego nagłówka; %1</translation>
    </message>
    <message>
        <source>is no row of a time and an action</source>
        <translation>nie jest wierszem z czasem i czynnością</translation>
    </message>
    <message>
        <source>%1 is no time; expected seconds</source>
        <translation>%1 nie jest czasem; oczekiwano sekund</translation>
    </message>
    <message>
        <source>there is no action</source>
        <translation>brak czynności</translation>
    </message>
    <message>
        <source>time goes back, from %1 to %2; expected actions in order of time</source>
        <translation>czas cofa się, z %1 do %2; oczekiwano czynności w kolejności czasu</translation>
    </message>
    <message>
        <source>there are more than %1 actions, or one of more than %2 bytes; expected what was switched in a test</source>
        <translation>czynności jest więcej niż %1 albo jedna ma więcej niż %2 bajtów; oczekiwano tego, co przełączano podczas próby</translation>
    </message>
    <message>
        <source>holds no actions; %1</source>
        <translation>nie zawiera czynności; %1</translation>
    </message>
    <message>
        <source>a CSV of actions</source>
        <translation>plik CSV z czynnościami</translation>
    </message>
    <message>
        <source>there is no column %1; expected %2</source>
        <translation>nie ma kolumny %1; oczekiwano %2</translation>
    </message>
    <message>
        <source>track_deg and ground_speed_kt, and leg, compass_heading_deg and variation_deg where they are known</source>
        <translation>track_deg i ground_speed_kt oraz, gdzie są znane, leg, compass_heading_deg i variation_deg</translation>
    </message>
    <message>
        <source>a Legs CSV: track_deg, ground_speed_kt, a leg or a part of one a row</source>
        <translation>plik Legs CSV: track_deg, ground_speed_kt, odcinek lub jego część w wierszu</translation>
    </message>
    <message>
        <source>a speed over ground</source>
        <translation>prędkość względem ziemi</translation>
    </message>
    <message>
        <source>there are more than %1 legs; expected a column leg that says which rows belong together</source>
        <translation>odcinków jest więcej niż %1; oczekiwano kolumny leg, która mówi, które wiersze należą do siebie</translation>
    </message>
    <message>
        <source>a Legs CSV</source>
        <translation>plik Legs CSV</translation>
    </message>
    <message>
        <source>time_s, compass_heading_deg, and reference_heading_deg (magnetic) or deviation_deg</source>
        <translation>time_s, compass_heading_deg oraz reference_heading_deg (magnetyczny) lub deviation_deg</translation>
    </message>
    <message>
        <source>a log: time_s, compass_heading_deg, and reference_heading_deg or deviation_deg</source>
        <translation>zapis: time_s, compass_heading_deg oraz reference_heading_deg lub deviation_deg</translation>
    </message>
    <message>
        <source>there are %1 loads; expected %2 at most</source>
        <translation>odbiorników jest %1; oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>the state that was kept has other electrical loads than this log; expected the same current_A columns</source>
        <translation>zachowany stan ma inne odbiorniki elektryczne niż ten zapis; oczekiwano tych samych kolumn current_A</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>sekundy</translation>
    </message>
    <message>
        <source>time_s goes back to %1; expected times in order</source>
        <translation>time_s cofa się do %1; oczekiwano czasów po kolei</translation>
    </message>
    <message>
        <source>a heading is outside 0 to 360; expected degrees</source>
        <translation>kurs wykracza poza 0 do 360; oczekiwano stopni</translation>
    </message>
    <message>
        <source>reference_error_deg is not above 0; expected a standard deviation</source>
        <translation>reference_error_deg nie jest większe od 0; oczekiwano odchylenia standardowego</translation>
    </message>
    <message>
        <source>holds no pair of headings; expected a compass and a reference heading a row</source>
        <translation>nie zawiera pary kursów; oczekiwano w wierszu kursu kompasowego i wzorcowego</translation>
    </message>
    <message>
        <source>a log of headings</source>
        <translation>zapis kursów</translation>
    </message>
    <message>
        <source>there are %1 columns; expected at most %2</source>
        <translation>kolumn jest %1; oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>two columns are %1: %2 and %3; expected one</source>
        <translation>dwie kolumny to %1: %2 i %3; oczekiwano jednej</translation>
    </message>
    <message>
        <source>there is no column %1 for %2</source>
        <translation>nie ma kolumny %1 dla %2</translation>
    </message>
    <message>
        <source>%1 is nothing that a column can be; expected time, bx, by, bz, heading, pitch or roll</source>
        <translation>%1 nie może być kolumną; oczekiwano czasu, bx, by, bz, kursu, pochylenia lub przechylenia</translation>
    </message>
    <message>
        <source>has no column %1; expected bx_nT, by_nT, bz_nT (or _uT, _mG, _G, or no unit for counts), or say which it is</source>
        <translation>nie ma kolumny %1; oczekiwano bx_nT, by_nT, bz_nT (albo _uT, _mG, _G, albo bez jednostki dla zliczeń) lub wskazania, która to jest</translation>
    </message>
    <message>
        <source>the axes are in different units: %1, %2, %3; expected one</source>
        <translation>osie są w różnych jednostkach: %1, %2, %3; oczekiwano jednej</translation>
    </message>
    <message>
        <source>as chosen</source>
        <translation>jak wybrano</translation>
    </message>
    <message>
        <source>the column names say so</source>
        <translation>tak mówią nazwy kolumn</translation>
    </message>
    <message>
        <source>the field&apos;s size, %1, lies where the Earth&apos;s field does in %2</source>
        <translation>wielkość pola, %1, leży tam, gdzie pole Ziemi w %2</translation>
    </message>
    <message>
        <source>the columns name no unit; taken for %1: the field&apos;s size, %2, lies where the Earth&apos;s field does in that unit</source>
        <translation>kolumny nie podają jednostki; przyjęto %1: wielkość pola, %2, leży tam, gdzie w tej jednostce pole Ziemi</translation>
    </message>
    <message>
        <source>the columns name no unit: raw counts</source>
        <translation>kolumny nie podają jednostki: surowe zliczenia</translation>
    </message>
    <message>
        <source>the columns name no unit and are taken for raw counts; their size, %1, would fit %2: choose that unit if it is</source>
        <translation>kolumny nie podają jednostki i przyjęto surowe zliczenia; ich wielkość, %1, pasowałaby do %2: wybierz tę jednostkę, jeśli to ona</translation>
    </message>
    <message>
        <source>the field&apos;s size is %1 %2, which is no field of the Earth; it would be one in %3</source>
        <translation>wielkość pola wynosi %1 %2, a to nie pole Ziemi; byłoby nim w %3</translation>
    </message>
    <message>
        <source>expected a sensor log CSV: a header with bx_nT, by_nT, bz_nT, and one sample a row</source>
        <translation>oczekiwano zapisu czujnika w CSV: nagłówka z bx_nT, by_nT, bz_nT i jednej próbki w wierszu</translation>
    </message>
    <message>
        <source>has no header, and %1 numbers a row; expected three (x, y, z), four (time, x, y, z), or names</source>
        <translation>nie ma nagłówka, a w wierszu jest liczb: %1; oczekiwano trzech (x, y, z), czterech (czas, x, y, z) albo nazw</translation>
    </message>
    <message>
        <source>%1 in column %2 is no number, as more than %3 cells before it; expected one, or an empty cell</source>
        <translation>%1 w kolumnie %2 nie jest liczbą, jak ponad %3 komórek przed nią; oczekiwano liczby lub pustej komórki</translation>
    </message>
    <message>
        <source>line %1: %2 in column %3 is no number; its row counts as empty there</source>
        <translation>wiersz %1: %2 w kolumnie %3 nie jest liczbą; wiersz liczy się tam jako pusty</translation>
    </message>
    <message>
        <source>the row has %1 cells where the header has %2, as many rows before it; expected a cell a column</source>
        <translation>wiersz ma komórek %1, a nagłówek %2, jak wiele wierszy przed nim; oczekiwano jednej komórki na kolumnę</translation>
    </message>
    <message>
        <source>%1 columns that are no field, heading or current hold more than %2 cells; expected a log without them</source>
        <translation>kolumn, które nie są polem, kursem ani prądem, jest %1 i mają ponad %2 komórek; oczekiwano zapisu bez nich</translation>
    </message>
    <message>
        <source>time goes back, from %1 to %2; expected rows in order of time, of one log</source>
        <translation>czas cofa się, z %1 do %2; oczekiwano wierszy w kolejności czasu, z jednego zapisu</translation>
    </message>
    <message>
        <source>holds no samples; %1</source>
        <translation>nie zawiera próbek; %1</translation>
    </message>
    <message>
        <source>there is no header: the columns are taken for %1</source>
        <translation>brak nagłówka: kolumny przyjęto za %1</translation>
    </message>
    <message>
        <source>a sensor log</source>
        <translation>zapis czujnika</translation>
    </message>
    <message>
        <source>places and fields: x_m, y_m, z_m, bx_nT, by_nT, bz_nT, a reading a row</source>
        <translation>miejsca i pola: x_m, y_m, z_m, bx_nT, by_nT, bz_nT, jeden odczyt w wierszu</translation>
    </message>
    <message>
        <source>there is no column %1; expected x_m, y_m, z_m, bx_nT, by_nT and bz_nT</source>
        <translation>nie ma kolumny %1; oczekiwano x_m, y_m, z_m, bx_nT, by_nT i bz_nT</translation>
    </message>
    <message>
        <source>there is no figure for %1; expected one in each cell</source>
        <translation>brak liczby dla %1; oczekiwano jej w każdej komórce</translation>
    </message>
    <message>
        <source>places and fields</source>
        <translation>miejsca i pola</translation>
    </message>
    <message>
        <source>%1 is a text of %2 bytes; expected at most %3</source>
        <translation>%1 to tekst długości %2 bajtów; oczekiwano najwyżej %3</translation>
    </message>
    <message>
        <source>there are more than %1 keys; expected the particulars of a swing</source>
        <translation>kluczy jest więcej niż %1; oczekiwano danych pomiaru</translation>
    </message>
    <message>
        <source>lines of # take more than %1 MiB and no header follows; %2</source>
        <translation>linie z # zajmują ponad %1 MiB i nie ma po nich nagłówka; %2</translation>
    </message>
    <message>
        <source>the columns that mean nothing here take more than %1 MiB; expected a compass swing</source>
        <translation>kolumny, które nic tu nie znaczą, zajmują ponad %1 MiB; oczekiwano pomiaru dewiacji busoli</translation>
    </message>
    <message>
        <source>note and keys that mean nothing here are %1 bytes together; expected at most %2</source>
        <translation>uwaga i klucze, które nic tu nie znaczą, mają razem %1 bajtów; oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>a cell holds %1 bytes; expected at most %2</source>
        <translation>komórka ma %1 bajtów; oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>there is no column %1; expected ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt and ref_wind_from_deg; or, in place of both first, latitude_deg, longitude_deg and time_utc</source>
        <translation>nie ma kolumny %1; oczekiwano ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt i ref_wind_from_deg albo, zamiast dwóch pierwszych, latitude_deg, longitude_deg i time_utc</translation>
    </message>
    <message>
        <source>%1 is not known; expected one of %2</source>
        <translation>%1 jest nieznane; oczekiwano jednego z: %2</translation>
    </message>
    <message>
        <source>there is no column %1, which should be %2</source>
        <translation>nie ma kolumny %1, która powinna być: %2</translation>
    </message>
    <message>
        <source>the column %1 is meant to be two things; expected one</source>
        <translation>kolumna %1 ma być dwiema rzeczami; oczekiwano jednej</translation>
    </message>
    <message>
        <source>two columns are of the heading %1; expected each heading once</source>
        <translation>dwie kolumny są z kursu %1; każdego kursu oczekiwano raz</translation>
    </message>
    <message>
        <source>headings are columns (%1 …), and what stands in their cells is not said; expected it to be said: compass headings read, deviations (magnetic - compass), indication errors (compass - magnetic), or magnetic headings</source>
        <translation>kolumnami są kursy (%1 …), a nie powiedziano, co stoi w ich komórkach; oczekiwano wskazania: odczytane kursy kompasowe, dewiacje (magnetyczny - kompasowy), błędy wskazań (kompasowy - magnetyczny) lub kursy magnetyczne</translation>
    </message>
    <message>
        <source>columns and cells are both compass headings; expected the others in one of the two</source>
        <translation>kolumny i komórki są kursami kompasowymi; w jednym z nich oczekiwano tych drugich</translation>
    </message>
    <message>
        <source>columns and cells are both magnetic headings; expected the others in one of the two</source>
        <translation>kolumny i komórki są kursami magnetycznymi; w jednym z nich oczekiwano tych drugich</translation>
    </message>
    <message>
        <source>neither headings as columns nor two of magnetic_heading_deg, compass_heading_deg and deviation_deg are there; expected a row a swing or a row a reading</source>
        <translation>nie ma ani kursów jako kolumn, ani dwóch z magnetic_heading_deg, compass_heading_deg i deviation_deg; oczekiwano wiersza na pomiar albo wiersza na odczyt</translation>
    </message>
    <message>
        <source>headings are columns, and columns of single readings are there too; expected a row a swing or a row a reading</source>
        <translation>kolumnami są kursy i są też kolumny pojedynczych odczytów; oczekiwano wiersza na pomiar albo wiersza na odczyt</translation>
    </message>
    <message>
        <source>what the cells of heading columns are is said, but no column is a heading</source>
        <translation>powiedziano, co stoi w komórkach kolumn kursów, lecz żadna kolumna nie jest kursem</translation>
    </message>
    <message>
        <source>a table of swings: a header of named columns, and a row a swing or a row a reading</source>
        <translation>tabela pomiarów: nagłówek z nazwami kolumn i wiersz na pomiar albo wiersz na odczyt</translation>
    </message>
    <message>
        <source>has a header but no rows; expected %1</source>
        <translation>ma nagłówek, lecz nie ma wierszy; oczekiwano: %1</translation>
    </message>
    <message>
        <source>the key %1 is said twice for all swings; expected it once</source>
        <translation>klucz %1 podano dla wszystkich pomiarów dwa razy; oczekiwano raz</translation>
    </message>
    <message>
        <source>no column is the aircraft; expected a column of registrations</source>
        <translation>żadna kolumna nie jest statkiem powietrznym; oczekiwano kolumny ze znakami rejestracyjnymi</translation>
    </message>
    <message>
        <source>no column is the date; expected a column of the days of the swings</source>
        <translation>żadna kolumna nie jest datą; oczekiwano kolumny z dniami pomiarów</translation>
    </message>
    <message>
        <source>the column %1 means nothing here; it is kept in the swings&apos; notes</source>
        <translation>kolumna %1 nic tu nie znaczy; zachowano ją w uwagach pomiarów</translation>
    </message>
    <message>
        <source>true headings stand in place of magnetic ones, and no variation_deg is said for them</source>
        <translation>zamiast kursów magnetycznych stoją rzeczywiste, a nie podano dla nich variation_deg</translation>
    </message>
    <message>
        <source>no heading of this swing has a reading; expected at least one</source>
        <translation>żaden kurs tego pomiaru nie ma odczytu; oczekiwano co najmniej jednego</translation>
    </message>
    <message>
        <source>a swing goes on here that rows above began, with others between; expected the rows of a swing to stand together, or a column &quot;swing&quot; that tells it from the other</source>
        <translation>trwa tu pomiar zaczęty w wierszach powyżej, a między nimi są inne; oczekiwano wierszy pomiaru obok siebie albo kolumny „swing”, która go odróżnia</translation>
    </message>
    <message>
        <source>the aircraft is not named in this row; expected its registration</source>
        <translation>w tym wierszu nie podano statku powietrznego; oczekiwano znaków rejestracyjnych</translation>
    </message>
    <message>
        <source>the date is not stated in this row; expected the day of the swing</source>
        <translation>w tym wierszu nie podano daty; oczekiwano dnia pomiaru</translation>
    </message>
    <message>
        <source>%1: %2 is no day; expected %3</source>
        <translation>%1: %2 nie jest dniem; oczekiwano %3</translation>
    </message>
    <message>
        <source>day, month and year, as 31.12.2019</source>
        <translation>dzień, miesiąc i rok, jak 31.12.2019</translation>
    </message>
    <message>
        <source>month, day and year, as 12/31/2019</source>
        <translation>miesiąc, dzień i rok, jak 12/31/2019</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>RRRR-MM-DD</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>kolumna %1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 deviations are larger than 45°: look whether the columns are what they were said to be</source>
        <translation>%1 z %2 dewiacji przekracza 45°: sprawdź, czy kolumny są tym, co o nich powiedziano</translation>
    </message>
    <message>
        <source>this is no signed content of version 3; expected what `export --signature` writes</source>
        <translation>to nie jest podpisana treść wersji 3; oczekiwano tego, co zapisuje `export --signature`</translation>
    </message>
    <message>
        <source>signed content</source>
        <translation>podpisana treść</translation>
    </message>
    <message>
        <source>particulars</source>
        <translation>dane</translation>
    </message>
    <message>
        <source>do not read</source>
        <translation>nie dają się odczytać</translation>
    </message>
    <message>
        <source>%1 of the type</source>
        <translation>%1 typu</translation>
    </message>
    <message>
        <source>%1 of the aircraft</source>
        <translation>%1 statku powietrznego</translation>
    </message>
    <message>
        <source>%1 of the compass</source>
        <translation>%1 busoli</translation>
    </message>
    <message>
        <source>%1 of the site</source>
        <translation>%1 miejsca</translation>
    </message>
    <message>
        <source>%1 of the limits</source>
        <translation>%1 wartości dopuszczalnych</translation>
    </message>
    <message>
        <source>%1: has more than %2 keys; expected %3</source>
        <translation>%1: ma więcej niż %2 kluczy; oczekiwano %3</translation>
    </message>
    <message>
        <source>%1: the values up to here take more than %2 MiB; expected %3, of a smaller size</source>
        <translation>%1: wartości do tego miejsca zajmują ponad %2 MiB; oczekiwano %3 mniejszych rozmiarów</translation>
    </message>
    <message>
        <source>is a text of %1 bytes; expected at most %2</source>
        <translation>to tekst długości %1 bajtów; oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>a table of two compasses read together</source>
        <translation>tabela dwóch busol odczytanych razem</translation>
    </message>
    <message>
        <source>%1 is nested too deeply; expected at most %2 points in it</source>
        <translation>%1 jest zagnieżdżone zbyt głęboko; oczekiwano najwyżej %2 kropek</translation>
    </message>
    <message>
        <source>a table with the columns %1 and %2</source>
        <translation>tabela z kolumnami %1 i %2</translation>
    </message>
    <message>
        <source>no column %1; expected it in the header</source>
        <translation>nie ma kolumny %1; oczekiwano jej w nagłówku</translation>
    </message>
    <message>
        <source>expected a bearing of the shadow or of the sun, one of them in each row</source>
        <translation>oczekiwano namiaru cienia albo słońca, jednego z nich w każdym wierszu</translation>
    </message>
    <message>
        <source>a table of compass headings and bearings of the sun</source>
        <translation>tabela kursów kompasowych i namiarów słońca</translation>
    </message>
    <message>
        <source>the state of a continuous swing</source>
        <translation>stan pomiaru ciągłego</translation>
    </message>
    <message>
        <source>is another; expected the state of a continuous swing</source>
        <translation>jest inny; oczekiwano stanu pomiaru ciągłego</translation>
    </message>
    <message>
        <source>is not %1: it was written by another version of the program</source>
        <translation>nie wynosi %1: zapisała to inna wersja programu</translation>
    </message>
    <message>
        <source>has more than %1 loads</source>
        <translation>ma więcej niż %1 odbiorników</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>liczby</translation>
    </message>
    <message>
        <source>is no covariance; expected a symmetric one that is not negative</source>
        <translation>nie jest kowariancją; oczekiwano macierzy symetrycznej i nieujemnej</translation>
    </message>
    <message>
        <source>neighbouring innovations resemble each other (correlation %1): errors of the reference last longer than an update; standard errors are widened %2 times</source>
        <translation>sąsiednie innowacje są do siebie podobne (korelacja %1): błędy wzorca trwają dłużej niż aktualizacja; błędy standardowe poszerzono %2 razy</translation>
    </message>
    <message>
        <source>%1 is not told by the headings and loads so far</source>
        <translation>dotychczasowe kursy i odbiorniki nie określają %1</translation>
    </message>
    <message>
        <source>the iron changed: %1 by %2° ± %3°, between %4 s and %5 s</source>
        <translation>żelazo się zmieniło: %1 o %2° ± %3°, między %4 s a %5 s</translation>
    </message>
    <message>
        <source>there are %1 legs; expected three at least, on headings all round</source>
        <translation>odcinków jest %1; oczekiwano co najmniej trzech, na kursach dookoła</translation>
    </message>
    <message>
        <source>the legs do not tell the wind: their directions over ground lie on too short an arc; expected them all round, as 120° apart</source>
        <translation>odcinki nie określają wiatru: ich kierunki nad ziemią leżą na zbyt krótkim łuku; oczekiwano ich dookoła, np. co 120°</translation>
    </message>
    <message>
        <source>three legs determine the wind exactly: nothing is left to check it; errors are those of %1 kt in each leg</source>
        <translation>trzy odcinki wyznaczają wiatr dokładnie: nie zostaje nic do sprawdzenia; błędy odpowiadają %1 w na każdym odcinku</translation>
    </message>
    <message>
        <source>the legs are off one circle by %1 kt: wind or airspeed changed between them</source>
        <translation>odcinki odbiegają od jednego okręgu o %1 w: wiatr lub prędkość powietrzna zmieniły się między nimi</translation>
    </message>
    <message>
        <source>no variation is stated: headings are true, and deviations are not told</source>
        <translation>nie podano deklinacji: kursy są rzeczywiste, a dewiacji nie określono</translation>
    </message>
    <message>
        <source>D and E are told, and are not surely there (%1): the table is that of A, B and C</source>
        <translation>D i E są określone, lecz nie są pewne (%1): tablica obejmuje A, B i C</translation>
    </message>
    <message>
        <source>D and E are there (%1): the table is no sine</source>
        <translation>D i E występują (%1): tablica nie jest sinusoidą</translation>
    </message>
    <message>
        <source>the deviation changed between the flights %1 and %2 (%3); the fit is of the flights since</source>
        <translation>dewiacja zmieniła się między lotami %1 i %2 (%3); dopasowano loty od tego czasu</translation>
    </message>
    <message>
        <source>there is no group and no aircraft %1 to hold the others against</source>
        <translation>nie ma grupy ani statku powietrznego %1, z którymi można porównać pozostałe</translation>
    </message>
    <message>
        <source>the ground velocity of %1 reports is that between positions; the steps in which these are written make it uncertain by %2 kt</source>
        <translation>prędkość względem ziemi %1 meldunków policzono z położeń; krok, z jakim je zapisano, daje jej niepewność %2 w</translation>
    </message>
    <message>
        <source>%1° was read after the compass was turned by %2° in its mount: that is taken off what it read</source>
        <translation>%1° odczytano po obróceniu busoli w mocowaniu o %2°: odjęto to od odczytu</translation>
    </message>
    <message>
        <source>a control was turned since this heading was skipped, so that it cannot be read as it was found; the check swing reads it</source>
        <translation>od pominięcia tego kursu obrócono regulację, więc nie można go odczytać w stanie zastanym; odczyta go pomiar kontrolny</translation>
    </message>
    <message>
        <source>A is %1°: a clock an hour fast makes %2° of it here; look whether it shows daylight saving</source>
        <translation>A wynosi %1°: zegar spieszący godzinę daje tu %2° z tego; sprawdź, czy nie pokazuje czasu letniego</translation>
    </message>
    <message>
        <source>A is %1°: a clock an hour slow makes %2° of it here; look whether it shows daylight saving</source>
        <translation>A wynosi %1°: zegar spóźniony o godzinę daje tu %2° z tego; sprawdź, czy nie pokazuje czasu letniego</translation>
    </message>
    <message>
        <source>shadow pin (the sun)</source>
        <translation>pręt cieniowy (słońce)</translation>
    </message>
    <message>
        <source>a corrector stands at the end of its reach: the iron is more than it can take away; look for the source, or move the sensor</source>
        <translation>korektor stoi na końcu zakresu: żelaza jest więcej, niż może usunąć; poszukaj źródła albo przenieś czujnik</translation>
    </message>
    <message>
        <source>the analysis was cancelled</source>
        <translation>analizę anulowano</translation>
    </message>
    <message>
        <source>not read on %1</source>
        <translation>nie odczytano na %1</translation>
    </message>
    <message>
        <source>not read on %1 (%2)</source>
        <translation>nie odczytano na %1 (%2)</translation>
    </message>
    <message>
        <source>the base states %1</source>
        <translation>baza podaje %1</translation>
    </message>
    <message>
        <source>its survey found %1</source>
        <translation>jej pomiar wykazał %1</translation>
    </message>
    <message>
        <source>the model has %1</source>
        <translation>model ma %1</translation>
    </message>
    <message>
        <source>the swing states %1</source>
        <translation>pomiar dewiacji podaje %1</translation>
    </message>
    <message>
        <source>VARIATION in doubt, by %1: %2</source>
        <translation>WĄTPLIWA DEKLINACJA, o %1: %2</translation>
    </message>
    <message>
        <source>the headings of %1 do not tell %2: its type&apos;s is taken (%3)</source>
        <translation>kursy z %1 nie określają %2: przyjęto wartość typu (%3)</translation>
    </message>
    <message>
        <source>a workbook of a spreadsheet program</source>
        <translation>skoroszyt arkusza kalkulacyjnego</translation>
    </message>
    <message numerus="yes">
        <source>%n gap(s) in time, the longest %1 s, together %2 s</source>
        <translation>
            <numerusform>%n przerwa w czasie, najdłuższa %1 s, razem %2 s</numerusform>
            <numerusform>%n przerwy w czasie, najdłuższa %1 s, razem %2 s</numerusform>
            <numerusform>%n przerw w czasie, najdłuższa %1 s, razem %2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>axis %1 is stuck in %n row(s): its figure stands while another axis moves</source>
        <translation>
            <numerusform>oś %1 stoi w %n wierszu: jej wartość się nie zmienia, gdy inna oś się rusza</numerusform>
            <numerusform>oś %1 stoi w %n wierszach: jej wartość się nie zmienia, gdy inna oś się rusza</numerusform>
            <numerusform>oś %1 stoi w %n wierszach: jej wartość się nie zmienia, gdy inna oś się rusza</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>axis %1 is cut off at %2 %3 in %n row(s): the field is beyond the sensor&apos;s range</source>
        <translation>
            <numerusform>oś %1 jest obcięta na %2 %3 w %n wierszu: pole przekracza zakres czujnika</numerusform>
            <numerusform>oś %1 jest obcięta na %2 %3 w %n wierszach: pole przekracza zakres czujnika</numerusform>
            <numerusform>oś %1 jest obcięta na %2 %3 w %n wierszach: pole przekracza zakres czujnika</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>both were read on %n heading(s) only; what changed elsewhere is not seen</source>
        <translation>
            <numerusform>obie odczytano tylko na %n kursie; tego, co zmieniło się gdzie indziej, nie widać</numerusform>
            <numerusform>obie odczytano tylko na %n kursach; tego, co zmieniło się gdzie indziej, nie widać</numerusform>
            <numerusform>obie odczytano tylko na %n kursach; tego, co zmieniło się gdzie indziej, nie widać</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) with both headings; expected at least 3 on different headings</source>
        <translation>
            <numerusform>%n odczyt z oboma kursami; oczekiwano co najmniej 3 na różnych kursach</numerusform>
            <numerusform>%n odczyty z oboma kursami; oczekiwano co najmniej 3 na różnych kursach</numerusform>
            <numerusform>%n odczytów z oboma kursami; oczekiwano co najmniej 3 na różnych kursach</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all %1 readings are on %n heading(s); expected at least 3 different headings</source>
        <translation>
            <numerusform>wszystkie odczyty (%1) są na %n kursie; oczekiwano co najmniej 3 różnych kursów</numerusform>
            <numerusform>wszystkie odczyty (%1) są na %n kursach; oczekiwano co najmniej 3 różnych kursów</numerusform>
            <numerusform>wszystkie odczyty (%1) są na %n kursach; oczekiwano co najmniej 3 różnych kursów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n month(s) after the swing of %2</source>
        <translation>
            <numerusform>%1: %n miesiąc po pomiarze z %2</numerusform>
            <numerusform>%1: %n miesiące po pomiarze z %2</numerusform>
            <numerusform>%1: %n miesięcy po pomiarze z %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the line has %n figure(s); it is cut short</source>
        <translation>
            <numerusform>wiersz ma %n liczbę; jest ucięty</numerusform>
            <numerusform>wiersz ma %n liczby; jest ucięty</numerusform>
            <numerusform>wiersz ma %n liczb; jest ucięty</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>has %n word(s) where the header has %1</source>
        <translation>
            <numerusform>ma %n wyraz, a nagłówek %1</numerusform>
            <numerusform>ma %n wyrazy, a nagłówek %1</numerusform>
            <numerusform>ma %n wyrazów, a nagłówek %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) left out: %1</source>
        <translation>
            <numerusform>pominięto %n pomiar: %1</numerusform>
            <numerusform>pominięto %n pomiary: %1</numerusform>
            <numerusform>pominięto %n pomiarów: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) not held against a limit: their compass has none</source>
        <translation>
            <numerusform>%n pary nie porównano z granicą: jej busola jej nie ma</numerusform>
            <numerusform>%n par nie porównano z granicą: ich busole jej nie mają</numerusform>
            <numerusform>%n par nie porównano z granicą: ich busole jej nie mają</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) not compared through the years: the other radio state</source>
        <translation>
            <numerusform>%n pomiaru nie porównano na przestrzeni lat: inny stan radia</numerusform>
            <numerusform>%n pomiarów nie porównano na przestrzeni lat: inny stan radia</numerusform>
            <numerusform>%n pomiarów nie porównano na przestrzeni lat: inny stan radia</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) known: mostly its type&apos;s scatter</source>
        <translation>
            <numerusform>znany jest %n pomiar: głównie rozrzut typu</numerusform>
            <numerusform>znane są %n pomiary: głównie rozrzut typu</numerusform>
            <numerusform>znanych jest %n pomiarów: głównie rozrzut typu</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has %2 bytes; expected at most %3</source>
        <translation>%1 ma %2 bajtów; oczekiwano najwyżej %3</translation>
    </message>
    <message>
        <source>there are more than %1 legs; expected those of a flight, each of many rows</source>
        <translation>odcinków jest więcej niż %1; oczekiwano odcinków jednego lotu, każdy z wielu wierszy</translation>
    </message>
    <message numerus="yes">
        <source>the row has %n cell(s); expected %1 cells as in the header</source>
        <translation>
            <numerusform>wiersz ma %n komórkę; oczekiwano %1, jak w nagłówku</numerusform>
            <numerusform>wiersz ma %n komórki; oczekiwano %1, jak w nagłówku</numerusform>
            <numerusform>wiersz ma %n komórek; oczekiwano %1, jak w nagłówku</numerusform>
        </translation>
    </message>
    <message>
        <source>there are more than %1 aircraft; expected reports of fewer at a time</source>
        <translation>statków powietrznych jest więcej niż %1; oczekiwano naraz meldunków mniejszej liczby</translation>
    </message>
    <message>
        <source>there are more than %1 flights; expected reports of fewer at a time, and those of a flight together</source>
        <translation>lotów jest więcej niż %1; oczekiwano naraz meldunków mniejszej liczby, a meldunków jednego lotu obok siebie</translation>
    </message>
    <message numerus="yes">
        <source>no fix: the receiver says so in all %n of its RMC and VTG (status V, mode N), so there is no track to hold the compass against</source>
        <translation>
            <numerusform>brak pozycji: odbiornik mówi to w swoim jedynym RMC lub VTG (%n; stan V, tryb N), więc nie ma kąta drogi, z którym można porównać busolę</numerusform>
            <numerusform>brak pozycji: odbiornik mówi to we wszystkich %n RMC i VTG (stan V, tryb N), więc nie ma kąta drogi, z którym można porównać busolę</numerusform>
            <numerusform>brak pozycji: odbiornik mówi to we wszystkich %n RMC i VTG (stan V, tryb N), więc nie ma kąta drogi, z którym można porównać busolę</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentence(s) with a wrong checksum left out</source>
        <translation>
            <numerusform>pominięto %n zdanie z błędną sumą kontrolną</numerusform>
            <numerusform>pominięto %n zdania z błędną sumą kontrolną</numerusform>
            <numerusform>pominięto %n zdań z błędną sumą kontrolną</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentence(s) without a checksum: what was damaged on the way cannot be told</source>
        <translation>
            <numerusform>%n zdanie bez sumy kontrolnej: nie da się stwierdzić, czy uległo uszkodzeniu</numerusform>
            <numerusform>%n zdania bez sumy kontrolnej: nie da się stwierdzić, co uległo uszkodzeniu</numerusform>
            <numerusform>%n zdań bez sumy kontrolnej: nie da się stwierdzić, co uległo uszkodzeniu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n time(s) the receiver had no fix (status V, mode N)</source>
        <translation>
            <numerusform>%n raz odbiornik nie miał pozycji (stan V, tryb N)</numerusform>
            <numerusform>%n razy odbiornik nie miał pozycji (stan V, tryb N)</numerusform>
            <numerusform>%n razy odbiornik nie miał pozycji (stan V, tryb N)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n HDG sentence(s) with a deviation of their own (up to %1°, east +), which is not applied: the heading beside it is the sensor&apos;s before it; an instrument that has applied it already must be swung with it cleared</source>
        <translation>
            <numerusform>%n zdanie HDG z własną dewiacją (do %1°, wschodnia +), której nie zastosowano: kurs obok to kurs czujnika przed nią; przyrząd, który już ją zastosował, trzeba mierzyć z wyzerowaną</numerusform>
            <numerusform>%n zdania HDG z własną dewiacją (do %1°, wschodnia +), której nie zastosowano: kurs obok to kurs czujnika przed nią; przyrząd, który już ją zastosował, trzeba mierzyć z wyzerowaną</numerusform>
            <numerusform>%n zdań HDG z własną dewiacją (do %1°, wschodnia +), której nie zastosowano: kurs obok to kurs czujnika przed nią; przyrząd, który już ją zastosował, trzeba mierzyć z wyzerowaną</numerusform>
        </translation>
    </message>
    <message>
        <source>the variation of the log, %1° (east +), is held against no model: %2</source>
        <translation>deklinacji w zapisie, %1° (wschodnia +), nie porównano z żadnym modelem: %2</translation>
    </message>
    <message>
        <source>the log never moves faster than %1 kt, and a track counts from %2 kt on: below, it is the noise of the receiver</source>
        <translation>zapis nigdy nie porusza się szybciej niż %1 w, a kąt drogi liczy się od %2 w: poniżej to szum odbiornika</translation>
    </message>
    <message>
        <source>all of the turn is faster than %1°/s, and slower ones count only: a compass lags</source>
        <translation>cały obrót jest szybszy niż %1°/s, a liczą się tylko wolniejsze: busola się opóźnia</translation>
    </message>
    <message numerus="yes">
        <source>the N–S control was turned after %n reading(s) of the check swing: void, and to be read again</source>
        <translation>
            <numerusform>regulację N–S obrócono po %n odczycie pomiaru kontrolnego: nieważny, do powtórzenia</numerusform>
            <numerusform>regulację N–S obrócono po %n odczytach pomiaru kontrolnego: nieważne, do powtórzenia</numerusform>
            <numerusform>regulację N–S obrócono po %n odczytach pomiaru kontrolnego: nieważne, do powtórzenia</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the E–W control was turned after %n reading(s) of the check swing: void, and to be read again</source>
        <translation>
            <numerusform>regulację E–W obrócono po %n odczycie pomiaru kontrolnego: nieważny, do powtórzenia</numerusform>
            <numerusform>regulację E–W obrócono po %n odczytach pomiaru kontrolnego: nieważne, do powtórzenia</numerusform>
            <numerusform>regulację E–W obrócono po %n odczytach pomiaru kontrolnego: nieważne, do powtórzenia</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the index control was turned after %n reading(s) of the check swing: void, and to be read again</source>
        <translation>
            <numerusform>regulację indeksu obrócono po %n odczycie pomiaru kontrolnego: nieważny, do powtórzenia</numerusform>
            <numerusform>regulację indeksu obrócono po %n odczytach pomiaru kontrolnego: nieważne, do powtórzenia</numerusform>
            <numerusform>regulację indeksu obrócono po %n odczytach pomiaru kontrolnego: nieważne, do powtórzenia</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has %n reading(s) that count; expected at least %1</source>
        <translation>
            <numerusform>liczy się w nim %n odczyt; oczekiwano co najmniej %1</numerusform>
            <numerusform>liczą się w nim %n odczyty; oczekiwano co najmniej %1</numerusform>
            <numerusform>liczy się w nim %n odczytów; oczekiwano co najmniej %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is no error that readings share; expected degrees (of A) or letters with degrees, as in A 0.6 B 0.2</source>
        <translation>%1 nie jest błędem wspólnym odczytów; oczekiwano stopni (dla A) albo liter ze stopniami, jak A 0.6 B 0.2</translation>
    </message>
    <message>
        <source>errors that readings share</source>
        <translation>błędy wspólne odczytów</translation>
    </message>
    <message numerus="yes">
        <source>there are readings on %n heading(s), and five coefficients need five</source>
        <translation>
            <numerusform>odczyty są na %n kursie, a pięć współczynników wymaga pięciu</numerusform>
            <numerusform>odczyty są na %n kursach, a pięć współczynników wymaga pięciu</numerusform>
            <numerusform>odczyty są na %n kursach, a pięć współczynników wymaga pięciu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) cannot be checked against each other: a misread figure would not be seen</source>
        <translation>
            <numerusform>%n odczytu nie da się sprawdzić z innymi: źle odczytanej liczby nie byłoby widać</numerusform>
            <numerusform>%n odczytów nie da się sprawdzić wzajemnie: źle odczytanej liczby nie byłoby widać</numerusform>
            <numerusform>%n odczytów nie da się sprawdzić wzajemnie: źle odczytanej liczby nie byłoby widać</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) hold little against each other: a figure misread by less than about %1° could pass unseen</source>
        <translation>
            <numerusform>%n odczyt słabo sprawdza się z innymi: pomyłka mniejsza niż około %1° mogłaby przejść niezauważona</numerusform>
            <numerusform>%n odczyty słabo sprawdzają się wzajemnie: pomyłka mniejsza niż około %1° mogłaby przejść niezauważona</numerusform>
            <numerusform>%n odczytów słabo sprawdza się wzajemnie: pomyłka mniejsza niż około %1° mogłaby przejść niezauważona</numerusform>
        </translation>
    </message>
    <message>
        <source>what all readings share (datum, variation, delay, wind) is in the standard errors: %1</source>
        <translation>to, co wspólne wszystkim odczytom (wzorzec, deklinacja, opóźnienie, wiatr), jest w błędach standardowych: %1</translation>
    </message>
    <message>
        <source>no card: by the curve of these readings the compass runs backwards all the way around (it reads %1 on %2 and %3 on %4, magnetic); expected a compass that rises all the way around</source>
        <translation>brak tablicy: według krzywej tych odczytów busola biegnie wstecz dookoła (wskazuje %1 na %2 i %3 na %4, magnetycznie); oczekiwano busoli, która rośnie dookoła</translation>
    </message>
    <message>
        <source>the compass keeps between %1 and %2 while the aircraft turns through %3°: it sticks, or a field stronger than the Earth&apos;s holds it; no deviation can be told</source>
        <translation>busola pozostaje między %1 a %2, gdy statek powietrzny obraca się o %3°: zacina się albo trzyma ją pole silniejsze od ziemskiego; nie da się określić dewiacji</translation>
    </message>
    <message>
        <source>the compass does not follow the headings: the coefficients that come nearest have %1 %2° and leave a scatter of %3°; no deviation can be told; expected the readings of one compass beside the headings on which they were made</source>
        <translation>busola nie podąża za kursami: najbliższe współczynniki mają %1 %2° i zostawiają rozrzut %3°; nie da się określić dewiacji; oczekiwano odczytów jednej busoli obok kursów, na których je wykonano</translation>
    </message>
    <message>
        <source>of what the field along x, y and z does, and of hard iron, %1 of 4 can be told; expected 3 or more, as a swing through all headings tells</source>
        <translation>z tego, co robi pole wzdłuż x, y i z, oraz z żelaza twardego da się określić %1 z 4; oczekiwano 3 lub więcej, jak w pomiarze przez wszystkie kursy</translation>
    </message>
    <message>
        <source>%1 samples are of sizes up to %2 %5, and %3 of %4 %5 or more: two units in one log</source>
        <translation>%1 próbek ma wielkość do %2 %5, a %3 wielkość %4 %5 lub więcej: dwie jednostki w jednym zapisie</translation>
    </message>
    <message>
        <source>the samples spread by %1 %3 about one field of %2 %3: the sensor was hardly turned</source>
        <translation>próbki rozrzucają się o %1 %3 wokół jednego pola %2 %3: czujnika prawie nie obracano</translation>
    </message>
    <message>
        <source>noise of the aircraft&apos;s sensor</source>
        <translation>szum czujnika statku powietrznego</translation>
    </message>
    <message>
        <source>pitch of the aircraft</source>
        <translation>pochylenie statku powietrznego</translation>
    </message>
    <message>
        <source>roll of the aircraft</source>
        <translation>przechylenie statku powietrznego</translation>
    </message>
    <message>
        <source>noise of the helmet&apos;s sensor</source>
        <translation>szum czujnika hełmu</translation>
    </message>
    <message>
        <source>pitch of the helmet</source>
        <translation>pochylenie hełmu</translation>
    </message>
    <message>
        <source>roll of the helmet</source>
        <translation>przechylenie hełmu</translation>
    </message>
    <message>
        <source>roll of the turret&apos;s mount</source>
        <translation>przechylenie mocowania wieżyczki</translation>
    </message>
    <message>
        <source>pitch of the turret&apos;s mount</source>
        <translation>pochylenie mocowania wieżyczki</translation>
    </message>
    <message>
        <source>yaw of the turret&apos;s mount</source>
        <translation>odchylenie mocowania wieżyczki</translation>
    </message>
    <message>
        <source>iron at the aircraft&apos;s sensor</source>
        <translation>żelazo przy czujniku statku powietrznego</translation>
    </message>
    <message>
        <source>iron at the helmet&apos;s sensor</source>
        <translation>żelazo przy czujniku hełmu</translation>
    </message>
    <message>
        <source>field of the cockpit</source>
        <translation>pole kabiny</translation>
    </message>
    <message>
        <source>the line of sight is steeper than %1°: there an azimuth turns quickly, and its error is large by itself</source>
        <translation>linia wzroku jest bardziej stroma niż %1°: azymut szybko się tam obraca i jego błąd jest duży sam z siebie</translation>
    </message>
    <message>
        <source>the helmet looks almost straight up or down over the Earth: its heading and its roll are one thing there</source>
        <translation>hełm patrzy prawie prosto w górę lub w dół względem Ziemi: jego kurs i przechylenie są tam jednym</translation>
    </message>
    <message>
        <source>a field that coils in the cockpit make to track the helmet is not modelled: headings are by the Earth&apos;s field, a constant field of the cockpit is an error of it</source>
        <translation>pole, które cewki w kabinie wytwarzają do śledzenia hełmu, nie jest modelowane: kursy są według pola Ziemi, a stałe pole kabiny jest ich błędem</translation>
    </message>
    <message>
        <source>time stands at %1 s in all rows: no rate and no gaps are known</source>
        <translation>czas stoi na %1 s we wszystkich wierszach: częstość i przerwy są nieznane</translation>
    </message>
    <message>
        <source>heading_deg is what this compass itself reads, smoothed or delayed: it goes with its field, though iron must turn that; expected a reference of its own (inertial, GPS, datum compass)</source>
        <translation>heading_deg to wskazanie samej tej busoli, wygładzone lub opóźnione: idzie za jej polem, choć żelazo musi je obracać; oczekiwano osobnego wzorca (inercyjnego, GPS, busoli wzorcowej)</translation>
    </message>
    <message>
        <source>the time column names no unit; its steps of %1 are taken for %2, counted from the first row</source>
        <translation>kolumna czasu nie podaje jednostki; jej kroki po %1 przyjęto za %2, liczone od pierwszego wiersza</translation>
    </message>
    <message>
        <source>the time column names no unit; its steps of %1 are taken for %2</source>
        <translation>kolumna czasu nie podaje jednostki; jej kroki po %1 przyjęto za %2</translation>
    </message>
    <message>
        <source>is none: expected a symmetric matrix with no negative figure on its diagonal</source>
        <translation>nie jest nią: oczekiwano macierzy symetrycznej bez liczb ujemnych na przekątnej</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>miękkie</translation>
    </message>
    <message>
        <source>between</source>
        <translation>między</translation>
    </message>
    <message>
        <source>hard</source>
        <translation>twarde</translation>
    </message>
    <message>
        <source>part “%1” is soft (%2 A/m): it keeps no magnetism for long, and up to %3 nT of its hard iron may go with a shock</source>
        <translation>część „%1” jest miękka (%2 A/m): nie zachowuje długo magnetyzmu i po wstrząsie może zniknąć do %3 nT jej żelaza twardego</translation>
    </message>
    <message>
        <source>part “%1” is between soft and hard (%2 A/m): after a shock, under stress or after a strong current up to %3 nT may change; swing again then</source>
        <translation>część „%1” jest między miękką a twardą (%2 A/m): po wstrząsie, pod naprężeniem lub po silnym prądzie może się zmienić do %3 nT; wykonaj wtedy pomiar ponownie</translation>
    </message>
    <message>
        <source>a sensor model with its calibration&apos;s uncertainty</source>
        <translation>model czujnika z niepewnością jego kalibracji</translation>
    </message>
    <message>
        <source>%1; or another coefficient did, which explains as much on the headings since: %2</source>
        <translation>%1; albo zmienił się inny współczynnik, który na kursach od tego czasu wyjaśnia tyle samo: %2</translation>
    </message>
    <message>
        <source>OVER THE LIMIT of %1 (%2): the deviation on magnetic %3</source>
        <translation>PONAD GRANICĘ %1 (%2): dewiacja na kursie magnetycznym %3</translation>
    </message>
    <message>
        <source>OVER THE LIMIT of %1 (%2): the deviation on compass %3</source>
        <translation>PONAD GRANICĘ %1 (%2): dewiacja na kursie busoli %3</translation>
    </message>
    <message>
        <source>OVER THE LIMIT of %1 (%2): the deviation that was read on magnetic %3, %4</source>
        <translation>PONAD GRANICĘ %1 (%2): dewiacja odczytana na kursie magnetycznym %3, %4</translation>
    </message>
    <message>
        <source>axis %1 has figures of size %2 where the others have %3: another unit, or a column that is no field</source>
        <translation>oś %1 ma wartości rzędu %2, a pozostałe %3: inna jednostka albo kolumna, która nie jest polem</translation>
    </message>
    <message numerus="yes">
        <source>%n usable sample(s); expected %1 or more, in many attitudes</source>
        <translation>
            <numerusform>%n użyteczna próbka; oczekiwano co najmniej %1, w wielu położeniach</numerusform>
            <numerusform>%n użyteczne próbki; oczekiwano co najmniej %1, w wielu położeniach</numerusform>
            <numerusform>%n użytecznych próbek; oczekiwano co najmniej %1, w wielu położeniach</numerusform>
        </translation>
    </message>
    <message>
        <source>axis %1 measures %2 times as much as axis %3 of one field: another unit or scale; expected less than %4</source>
        <translation>oś %1 mierzy %2 razy tyle co oś %3 tego samego pola: inna jednostka lub skala; oczekiwano mniej niż %4</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) left out without a whole field (empty cells or NaN)</source>
        <translation>
            <numerusform>pominięto %n wiersz bez całego pola (puste komórki lub NaN)</numerusform>
            <numerusform>pominięto %n wiersze bez całego pola (puste komórki lub NaN)</numerusform>
            <numerusform>pominięto %n wierszy bez całego pola (puste komórki lub NaN)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spike(s) left out, away from both neighbours by more than 12 times the log&apos;s scatter</source>
        <translation>
            <numerusform>pominięto %n skok, odległy od obu sąsiadów o ponad 12 rozrzutów zapisu</numerusform>
            <numerusform>pominięto %n skoki, odległe od obu sąsiadów o ponad 12 rozrzutów zapisu</numerusform>
            <numerusform>pominięto %n skoków, odległych od obu sąsiadów o ponad 12 rozrzutów zapisu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) alike the row before: the sensor was read faster than it measures, which tells nothing new</source>
        <translation>
            <numerusform>%n wiersz taki jak poprzedni: czujnik odczytywano szybciej, niż mierzy, co nie mówi nic nowego</numerusform>
            <numerusform>%n wiersze takie jak poprzednie: czujnik odczytywano szybciej, niż mierzy, co nie mówi nic nowego</numerusform>
            <numerusform>%n wierszy takich jak poprzednie: czujnik odczytywano szybciej, niż mierzy, co nie mówi nic nowego</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not ranked, as no limit is known: %n compass system(s)</source>
        <translation>
            <numerusform>bez miejsca w kolejności, bo nie jest znana granica: %n układ busoli</numerusform>
            <numerusform>bez miejsca w kolejności, bo nie jest znana granica: %n układy busoli</numerusform>
            <numerusform>bez miejsca w kolejności, bo nie jest znana granica: %n układów busoli</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>suspect of the other sign as well: the records of %n more compass system(s)</source>
        <translation>
            <numerusform>podejrzane o przeciwny znak są też zapisy %n innego układu busoli</numerusform>
            <numerusform>podejrzane o przeciwny znak są też zapisy %n innych układów busoli</numerusform>
            <numerusform>podejrzane o przeciwny znak są też zapisy %n innych układów busoli</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: on %2 A lay %3 what is usual; its average stood at %4°</source>
        <translation>%1: w dniu %2 A leżało %3 tego, co zwykle; jego średnia wynosiła %4°</translation>
    </message>
    <message>
        <source>%1: from %2 to %3 A lay %4 what is usual; its average went as far as %5°</source>
        <translation>%1: od %2 do %3 A leżało %4 tego, co zwykle; jego średnia sięgnęła %5°</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) without a compass or reference heading passed over</source>
        <translation>
            <numerusform>pominięto %n wiersz bez kursu busoli lub wzorcowego</numerusform>
            <numerusform>pominięto %n wiersze bez kursu busoli lub wzorcowego</numerusform>
            <numerusform>pominięto %n wierszy bez kursu busoli lub wzorcowego</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n empty cell(s)</source>
        <translation>
            <numerusform>%n pusta komórka</numerusform>
            <numerusform>%n puste komórki</numerusform>
            <numerusform>%n pustych komórek</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) without a number (NaN)</source>
        <translation>
            <numerusform>%n komórka bez liczby (NaN)</numerusform>
            <numerusform>%n komórki bez liczby (NaN)</numerusform>
            <numerusform>%n komórek bez liczby (NaN)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) with fewer cells than the header</source>
        <translation>
            <numerusform>%n wiersz o mniejszej liczbie komórek niż nagłówek</numerusform>
            <numerusform>%n wiersze o mniejszej liczbie komórek niż nagłówek</numerusform>
            <numerusform>%n wierszy o mniejszej liczbie komórek niż nagłówek</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) above the header, where no column is named, kept in the swing&apos;s note</source>
        <translation>
            <numerusform>%n wiersz nad nagłówkiem, gdzie nie nazwano żadnej kolumny, zachowano w uwadze do dewiacji</numerusform>
            <numerusform>%n wiersze nad nagłówkiem, gdzie nie nazwano żadnej kolumny, zachowano w uwadze do dewiacji</numerusform>
            <numerusform>%n wierszy nad nagłówkiem, gdzie nie nazwano żadnej kolumny, zachowano w uwadze do dewiacji</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) not taken, too far from what was expected</source>
        <translation>
            <numerusform>nie przyjęto %n odczytu, zbyt odległego od oczekiwanego</numerusform>
            <numerusform>nie przyjęto %n odczytów, zbyt odległych od oczekiwanych</numerusform>
            <numerusform>nie przyjęto %n odczytów, zbyt odległych od oczekiwanych</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n report(s) that came twice counted once</source>
        <translation>
            <numerusform>%n meldunek, który przyszedł dwa razy, policzono raz</numerusform>
            <numerusform>%n meldunki, które przyszły dwa razy, policzono raz</numerusform>
            <numerusform>%n meldunków, które przyszły dwa razy, policzono raz</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>no true heading: the instrument says so in all %n of its THS (mode V)</source>
        <translation>
            <numerusform>brak kursu rzeczywistego: przyrząd sam to mówi w swoim %n THS (tryb V)</numerusform>
            <numerusform>brak kursu rzeczywistego: przyrząd sam to mówi we wszystkich %n THS (tryb V)</numerusform>
            <numerusform>brak kursu rzeczywistego: przyrząd sam to mówi we wszystkich %n THS (tryb V)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) of a standing aircraft left out: they repeat what it read at the end of its stand</source>
        <translation>
            <numerusform>pominięto %n odczyt stojącego samolotu: powtarza to, co odczytano pod koniec postoju</numerusform>
            <numerusform>pominięto %n odczyty stojącego samolotu: powtarzają to, co odczytano pod koniec postoju</numerusform>
            <numerusform>pominięto %n odczytów stojącego samolotu: powtarzają to, co odczytano pod koniec postoju</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n heading(s) left out, negative or beyond 360</source>
        <translation>
            <numerusform>pominięto %n kurs, ujemny lub powyżej 360</numerusform>
            <numerusform>pominięto %n kursy, ujemne lub powyżej 360</numerusform>
            <numerusform>pominięto %n kursów, ujemnych lub powyżej 360</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n time(s) the true heading was not valid (THS mode V)</source>
        <translation>
            <numerusform>%n raz kurs rzeczywisty był nieważny (THS, tryb V)</numerusform>
            <numerusform>%n razy kurs rzeczywisty był nieważny (THS, tryb V)</numerusform>
            <numerusform>%n razy kurs rzeczywisty był nieważny (THS, tryb V)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n estimated track(s) or heading(s) (mode E, dead reckoning): perhaps from the very compass that is swung</source>
        <translation>
            <numerusform>%n oszacowany kąt drogi lub kurs (tryb E, zliczenie): być może z tej samej busoli, którą się sprawdza</numerusform>
            <numerusform>%n oszacowane kąty drogi lub kursy (tryb E, zliczenie): być może z tej samej busoli, którą się sprawdza</numerusform>
            <numerusform>%n oszacowanych kątów drogi lub kursów (tryb E, zliczenie): być może z tej samej busoli, którą się sprawdza</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) or heading(s) typed in (mode M)</source>
        <translation>
            <numerusform>%n kąt drogi lub kurs wpisany ręcznie (tryb M)</numerusform>
            <numerusform>%n kąty drogi lub kursy wpisane ręcznie (tryb M)</numerusform>
            <numerusform>%n kątów drogi lub kursów wpisanych ręcznie (tryb M)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) or heading(s) from a simulator (mode S)</source>
        <translation>
            <numerusform>%n kąt drogi lub kurs z symulatora (tryb S)</numerusform>
            <numerusform>%n kąty drogi lub kursy z symulatora (tryb S)</numerusform>
            <numerusform>%n kątów drogi lub kursów z symulatora (tryb S)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n variation(s) or deviation(s) left out, written without a side as &apos;%1&apos;; expected a size without a sign, and E or W</source>
        <translation>
            <numerusform>pominięto %n deklinację lub dewiację zapisaną bez strony jako &apos;%1&apos;; oczekiwano wielkości bez znaku oraz E lub W</numerusform>
            <numerusform>pominięto %n deklinacje lub dewiacje zapisane bez strony jako &apos;%1&apos;; oczekiwano wielkości bez znaku oraz E lub W</numerusform>
            <numerusform>pominięto %n deklinacji lub dewiacji zapisanych bez strony jako &apos;%1&apos;; oczekiwano wielkości bez znaku oraz E lub W</numerusform>
        </translation>
    </message>
    <message>
        <source>the reading on %1 magnetic goes with none of the others: the coefficients mean nothing and there is no card until it is read again or excluded</source>
        <translation>odczyt na %1 magnetycznym nie zgadza się z żadnym z pozostałych: współczynniki nic nie znaczą i nie ma tabliczki, dopóki nie zostanie odczytany ponownie lub wykluczony</translation>
    </message>
    <message>
        <source>is no moment; expected UTC as YYYY-MM-DDTHH:MM:SSZ</source>
        <translation>nie jest chwilą; oczekiwano UTC jako RRRR-MM-DDTGG:MM:SSZ</translation>
    </message>
    <message>
        <source>the headings look turned by %1° against magnetic north: with that taken out they explain the samples far better; true headings where the variation is so? Expected magnetic headings</source>
        <translation>kursy wyglądają na obrócone o %1° względem północy magnetycznej: po odjęciu tego tłumaczą próbki znacznie lepiej; kursy geograficzne tam, gdzie deklinacja jest taka? Oczekiwano kursów magnetycznych</translation>
    </message>
    <message>
        <source>the sensor seems turned by %1°: of such a log nothing tells that from headings that are off by it, as true ones are by the variation</source>
        <translation>czujnik wydaje się obrócony o %1°: z takiego zapisu nie można tego odróżnić od kursów przesuniętych o tyle, jak kursy geograficzne o deklinację</translation>
    </message>
    <message>
        <source>not told which: the first has moved with %1 %, the second with %2 %, neither with %3 %; read them on more headings beside the datum</source>
        <translation>nie wiadomo która: pierwsza zmieniła się z prawdopodobieństwem %1 %, druga %2 %, żadna %3 %; odczytać obie na większej liczbie kursów obok wzorca</translation>
    </message>
    <message>
        <source>pitch_deg, roll_deg, horizontal_nT and dip_deg for the whole sensor model</source>
        <translation>pitch_deg, roll_deg, horizontal_nT i dip_deg dla całego modelu czujnika</translation>
    </message>
    <message>
        <source>is to go on from a state of another kind; expected both A to E, or both the whole sensor model</source>
        <translation>ma być kontynuowane ze stanu innego rodzaju; oczekiwano obu od A do E albo obu całego modelu czujnika</translation>
    </message>
    <message>
        <source>pitch_deg or roll_deg is out of range; expected -90 to 90, and -180 to 180</source>
        <translation>pitch_deg lub roll_deg poza zakresem; oczekiwano od -90 do 90 i od -180 do 180</translation>
    </message>
    <message>
        <source>horizontal_nT or dip_deg is out of range; expected 500 to 50000 nT, and -89 to 89</source>
        <translation>horizontal_nT lub dip_deg poza zakresem; oczekiwano od 500 do 50000 nT i od -89 do 89</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) without headings, attitude or field passed over</source>
        <translation>
            <numerusform>pominięto %n wiersz bez kursów, położenia przestrzennego lub pola</numerusform>
            <numerusform>pominięto %n wiersze bez kursów, położenia przestrzennego lub pola</numerusform>
            <numerusform>pominięto %n wierszy bez kursów, położenia przestrzennego lub pola</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1 holds the units of the columns and no reading</source>
        <translation>wiersz %1 zawiera jednostki kolumn i żadnego odczytu</translation>
    </message>
    <message>
        <source>line %1 is noted as %2 and taken for a reading: exclude it where it sums up the others</source>
        <translation>wiersz %1 ma uwagę „%2” i został przyjęty jako odczyt: wyłączyć go, jeśli jest podsumowaniem innych</translation>
    </message>
    <message>
        <source>line %1 is left out: %2 sums up the readings and is none</source>
        <translation>wiersz %1 pominięto: „%2” podsumowuje odczyty i nim nie jest</translation>
    </message>
    <message>
        <source>twelve rows of twelve numbers</source>
        <translation>dwanaście wierszy po dwanaście liczb</translation>
    </message>
    <message numerus="yes">
        <source>%n time(s) left out, no time of the day: &apos;%1&apos;; expected hhmmss</source>
        <translation>
            <numerusform>pominięto %n czas, który nie jest porą dnia: „%1”; oczekiwano ggmmss</numerusform>
            <numerusform>pominięto %n czasy, które nie są porą dnia: „%1”; oczekiwano ggmmss</numerusform>
            <numerusform>pominięto %n czasów, które nie są porą dnia: „%1”; oczekiwano ggmmss</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n date(s) left out, no day of the calendar: &apos;%1&apos;</source>
        <translation>
            <numerusform>pominięto %n datę, która nie jest dniem kalendarza: „%1”</numerusform>
            <numerusform>pominięto %n daty, które nie są dniami kalendarza: „%1”</numerusform>
            <numerusform>pominięto %n dat, które nie są dniami kalendarza: „%1”</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n position(s) left out, no place on the Earth: &apos;%1&apos;</source>
        <translation>
            <numerusform>pominięto %n pozycję, która nie jest miejscem na Ziemi: „%1”</numerusform>
            <numerusform>pominięto %n pozycje, które nie są miejscami na Ziemi: „%1”</numerusform>
            <numerusform>pominięto %n pozycji, które nie są miejscami na Ziemi: „%1”</numerusform>
        </translation>
    </message>
    <message>
        <source>the reference is %1 s newer than the heading beside it (standard error %2 s); that is taken out</source>
        <translation>wzorzec jest o %1 s nowszy niż kurs obok niego (błąd standardowy %2 s); zostało to odjęte</translation>
    </message>
    <message>
        <source>its date %1 is one from which clocks count that do not know the day (a receiver without a fix, a spreadsheet); expected the day on which it was swung</source>
        <translation>jej data %1 to jedna z tych, od których liczą zegary nieznające dnia (odbiornik bez pozycji, arkusz); oczekiwano dnia, w którym wykonano dewiację</translation>
    </message>
    <message>
        <source>its date %1 is what a receiver that missed the turn of the GPS week count (1024 weeks) writes for %2; expected the day on which it was swung</source>
        <translation>jej data %1 to ta, którą odbiornik po przeoczonym przejściu licznika tygodni GPS (1024 tygodnie) zapisuje zamiast %2; oczekiwano dnia, w którym wykonano dewiację</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) cannot tell a slip from a large coefficient: a figure misread by less than about %1° could pass unseen</source>
        <translation>
            <numerusform>z %n odczytu nie można odróżnić pomyłki od dużego współczynnika: odczyt błędny o mniej niż około %1° mógłby pozostać niezauważony</numerusform>
            <numerusform>z %n odczytów nie można odróżnić pomyłki od dużego współczynnika: odczyt błędny o mniej niż około %1° mógłby pozostać niezauważony</numerusform>
            <numerusform>z %n odczytów nie można odróżnić pomyłki od dużego współczynnika: odczyt błędny o mniej niż około %1° mógłby pozostać niezauważony</numerusform>
        </translation>
    </message>
    <message>
        <source>all headings lie between 0 and 6.3, as if they were in radians; expected degrees</source>
        <translation>wszystkie kursy leżą między 0 a 6,3, jakby były w radianach; oczekiwano stopni</translation>
    </message>
    <message>
        <source>the sun&apos;s azimuth tells little here (±%1°, one standard deviation)</source>
        <translation>azymut Słońca mówi tu niewiele (±%1°, jedno odchylenie standardowe)</translation>
    </message>
    <message>
        <source>not both benches state the sensor&apos;s serial number: whether it is the same sensor is not known</source>
        <translation>nie oba pomiary podają numer seryjny czujnika: nie wiadomo, czy to ten sam czujnik</translation>
    </message>
    <message>
        <source>the field went to %1 nT before and to %2 nT now: a sensor that is not straight has another scale over another range</source>
        <translation>pole sięgało przedtem %1 nT, a teraz %2 nT: czujnik nieliniowy ma w innym zakresie inną skalę</translation>
    </message>
    <message>
        <source>not both benches have a temperature: a difference may be its</source>
        <translation>nie oba pomiary mają temperaturę: różnica może od niej pochodzić</translation>
    </message>
    <message>
        <source>it was %1 °C before and %2 °C now: a difference may be the temperature&apos;s</source>
        <translation>przedtem było %1 °C, teraz %2 °C: różnica może pochodzić od temperatury</translation>
    </message>
    <message>
        <source>has %1 whole rows; a bench that is kept has at most %2, for its readings are kept whole: keep a part of the log</source>
        <translation>ma %1 pełnych wierszy; przechowywany pomiar stanowiskowy ma ich najwyżej %2, bo odczyty przechowuje się w całości: zachowaj część zapisu</translation>
    </message>
    <message>
        <source>are of two sensors (serial numbers %1 and %2) and cannot be compared</source>
        <translation>dotyczą dwóch czujników (numery seryjne %1 i %2) i nie można ich porównać</translation>
    </message>
    <message>
        <source>are one in counts and one in nT and cannot be compared</source>
        <translation>są jeden w zliczeniach, a drugi w nT, i nie można ich porównać</translation>
    </message>
    <message>
        <source>are %1 days apart: no drift is told from benches less than %2 days apart</source>
        <translation>dzieli %1 dni: z pomiarów bliższych niż %2 dni nie określa się dryfu</translation>
    </message>
    <message>
        <source>a date (YYYY-MM-DD)</source>
        <translation>daty (RRRR-MM-DD)</translation>
    </message>
    <message>
        <source>the readings of the bench and their count</source>
        <translation>odczytów pomiaru stanowiskowego i ich liczby</translation>
    </message>
    <message>
        <source>a coil bench</source>
        <translation>pomiar na stanowisku z cewkami</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> z %1</translation>
    </message>
    <message>
        <source>by its coil bench%1 the sensor itself leaves %2 nT on each reading, which is not in the errors: the field of the swing is not known</source>
        <translation>według stanowiska z cewkami%1 sam czujnik wnosi do każdego odczytu %2 nT, czego nie ma w błędach: pole pomiaru dewiacji nie jest znane</translation>
    </message>
    <message>
        <source>the sensor itself leaves %1° on each reading, in the errors: by its coil bench%2, noise %3, hysteresis %4 and nonlinearity %5 nT (standard uncertainties) in a field of %6 nT</source>
        <translation>sam czujnik wnosi do każdego odczytu %1°, ujęte w błędach: według stanowiska z cewkami%2 szum %3, histereza %4 i nieliniowość %5 nT (niepewności standardowe) w polu %6 nT</translation>
    </message>
    <message>
        <source>the compass reads the reciprocal: %1°%2 was taken out as its index before B, C, D and E; look whether it was read from the other side or is mounted back to front</source>
        <translation>busola wskazuje kurs odwrotny: %1°%2 usunięto jako jej indeks przed B, C, D i E; sprawdź, czy nie odczytano jej z drugiej strony albo nie zamontowano tyłem</translation>
    </message>
    <message>
        <source>the compass is %1°%2 out as a whole: this was taken out as its index before B, C, D and E; look at its mount and its lubber line</source>
        <translation>busola jest w całości przesunięta o %1°%2: usunięto to jako jej indeks przed B, C, D i E; sprawdź mocowanie i kreskę kursową</translation>
    </message>
    <message>
        <source>%1 and the compass %2 have one talker: if the one is made of the other, it shows no deviation of that compass</source>
        <translation>%1 i busola %2 mają jednego nadawcę: jeśli jedno powstaje z drugiego, nie pokaże dewiacji tej busoli</translation>
    </message>
    <message>
        <source>B, C, D and E are those of the compass turned right in its mount: their heading ψ&apos; is what it reads %1 %2° (the index); A of the approximate coefficients has the index in it, A of the exact ones has not</source>
        <translation>B, C, D i E są współczynnikami busoli ustawionej prosto w mocowaniu: ich kurs ψ&apos; to jej wskazanie %1 %2° (indeks); A przybliżone zawiera indeks, A dokładne go nie zawiera</translation>
    </message>
    <message>
        <source>A is %1°: B, C, D and E hold for the headings that the compass reads as it stands now. Turn it right in its mount before B and C are corrected, and swing again: B will be about %2° and C %3°</source>
        <translation>A wynosi %1°: B, C, D i E odnoszą się do kursów, które busola wskazuje w obecnym ustawieniu. Przed kompensacją B i C ustaw ją prosto w mocowaniu i powtórz dewiację: B wyniesie około %2°, a C %3°</translation>
    </message>
    <message>
        <source>%1, on a day that is not recorded: it may have been after the last swing</source>
        <translation>%1, dnia nie zapisano: mogło to być po ostatnim pomiarze</translation>
    </message>
    <message>
        <source>%1, dated %2, which cannot be right: it may have been after the last swing</source>
        <translation>%1, z datą %2, która nie może być prawdziwa: mogło to być po ostatnim pomiarze</translation>
    </message>
    <message>
        <source>%1 stands beside %2 and tells %3° more on average (east +): one of the two is wrong, and the log does not say which; %2 is taken, and A is no surer than that</source>
        <translation>obok %2 stoi %1 i podaje średnio o %3° więcej (wschód +): jedno z dwojga jest błędne, a dziennik nie mówi które; przyjęto %2, a A nie jest pewniejsze niż to</translation>
    </message>
    <message>
        <source>%1 differs from the compass by %2° at all headings, within %3°: no second instrument agrees so well. If it is made of this compass (by a multiplexer, a plotter, an autopilot), it shows no deviation, and no card may be made of it</source>
        <translation>%1 różni się od busoli o %2° na wszystkich kursach, z dokładnością do %3°: żaden drugi przyrząd nie zgadza się tak dobrze. Jeśli powstaje z tej busoli (w multiplekserze, ploterze, autopilocie), nie pokazuje dewiacji i nie wolno z niego robić tablicy dewiacji</translation>
    </message>
    <message>
        <source>THE COMPASS IS %1°%2 OUT AS A WHOLE: its mount, its lubber line, or from which side it was read, is to be looked at before anybody steers by it</source>
        <translation>BUSOLA JEST W CAŁOŚCI PRZESUNIĘTA O %1°%2: zanim ktokolwiek będzie według niej sterował, sprawdź jej mocowanie, kreskę kursową i stronę, z której ją odczytano</translation>
    </message>
    <message>
        <source>c apart from P, f apart from Q: the places are too alike, c/λ would be known within a standard error of %1</source>
        <translation>c osobno od P, f osobno od Q: miejsca są zbyt podobne, c/λ byłoby znane z błędem standardowym %1</translation>
    </message>
    <message>
        <source>the key %1 means nothing here; it is kept in the swing&apos;s note (did you mean %2?)</source>
        <translation>klucz %1 nic tu nie znaczy; zachowano go w uwadze do pomiaru (czy chodziło o %2?)</translation>
    </message>
    <message>
        <source>line %1 lists one heading, 000 and 360, with the same reading: it counts once</source>
        <translation>wiersz %1 podaje jeden kurs, 000 i 360, z tym samym odczytem: liczy się raz</translation>
    </message>
    <message>
        <source>line %1 lists one heading, 000 and 360, with different readings: both count, so look which is right</source>
        <translation>wiersz %1 podaje jeden kurs, 000 i 360, z różnymi odczytami: liczą się oba, więc sprawdź, który jest właściwy</translation>
    </message>
    <message>
        <source>%1 and %2 disagree by ±%3° over the headings: on wheels a track is the heading, so one of the two is wrong, or a heading that is made of the compass</source>
        <translation>%1 i %2 różnią się o ±%3° zależnie od kursu: na kołach kąt drogi jest kursem, więc jedno z dwojga jest błędne albo jest kursem utworzonym z busoli</translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) left out that jump away from the compass for a moment, as a receiver&apos;s do near walls</source>
        <translation>
            <numerusform>pominięto %n kąt drogi, który na chwilę odskakuje od busoli, jak w odbiorniku blisko ścian</numerusform>
            <numerusform>pominięto %n kąty drogi, które na chwilę odskakują od busoli, jak w odbiorniku blisko ścian</numerusform>
            <numerusform>pominięto %n kątów drogi, które na chwilę odskakują od busoli, jak w odbiorniku blisko ścian</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) left out that go backwards: the aircraft was pushed, and its track is not its heading</source>
        <translation>
            <numerusform>pominięto %n kąt drogi wstecz: statek powietrzny wypychano i kąt drogi nie jest jego kursem</numerusform>
            <numerusform>pominięto %n kąty drogi wstecz: statek powietrzny wypychano i kąt drogi nie jest jego kursem</numerusform>
            <numerusform>pominięto %n kątów drogi wstecz: statek powietrzny wypychano i kąt drogi nie jest jego kursem</numerusform>
        </translation>
    </message>
    <message>
        <source>A is %1°, near one step of the headings (%2°): the readings may stand one row off. Moved down by one row they make A %3°, B %4° and C %5°: look at the list before anybody touches the mount</source>
        <translation>A wynosi %1°, blisko jednego kroku kursów (%2°): odczyty mogą stać o wiersz obok. Przesunięte o wiersz w dół dają A %3°, B %4° i C %5°: sprawdź listę, zanim ktokolwiek ruszy mocowanie</translation>
    </message>
    <message>
        <source>A is %1°, near one step of the headings (%2°): the readings may stand one row off. Moved up by one row they make A %3°, B %4° and C %5°: look at the list before anybody touches the mount</source>
        <translation>A wynosi %1°, blisko jednego kroku kursów (%2°): odczyty mogą stać o wiersz obok. Przesunięte o wiersz w górę dają A %3°, B %4° i C %5°: sprawdź listę, zanim ktokolwiek ruszy mocowanie</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>około %1 s</translation>
    </message>
    <message>
        <source>about sample %1</source>
        <translation>około próbki %1</translation>
    </message>
    <message>
        <source>what the fit leaves over changes with time: along %1 it is %2 %3 more after %4 than before; expected less than %5 %3: iron that was put down or magnetised on the way, or a sensor that drifts</source>
        <translation>to, co zostaje po dopasowaniu, zmienia się w czasie: wzdłuż %1 jest po %4 o %2 %3 większe niż przedtem; oczekiwano mniej niż %5 %3: żelazo położone lub namagnesowane po drodze albo czujnik, który dryfuje</translation>
    </message>
    <message>
        <source>the sensor&apos;s gain changes with time: it is %1 % more after %2 than before; expected less than %3 %: a sensor that warms up, or another place</source>
        <translation>czułość czujnika zmienia się w czasie: po %2 jest o %1 % większa niż przedtem; oczekiwano mniej niż %3 %: czujnik, który się nagrzewa, albo inne miejsce</translation>
    </message>
    <message>
        <source>of the samples %1 to %2 most do not lie on what the others lie on: no spikes, but another field or other iron for that time</source>
        <translation>większość próbek od %1 do %2 nie leży na tym, na czym leżą pozostałe: to nie szpilki, lecz inne pole albo inne żelazo w tym czasie</translation>
    </message>
    <message>
        <source>log again with nothing moved on the way, or take the part of the log that is as the aircraft flies</source>
        <translation>zarejestruj ponownie, niczego po drodze nie ruszając, albo weź tę część dziennika, która odpowiada stanowi w locie</translation>
    </message>
    <message>
        <source>the log&apos;s field is %1 nT, and that of the Earth is %2 to %3 nT: another unit, or a sensor of another scale</source>
        <translation>pole w dzienniku wynosi %1 nT, a pole Ziemi od %2 do %3 nT: inna jednostka albo czujnik o innej skali</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 lub %2</translation>
    </message>
    <message>
        <source>this is the swing of %1 once more; expected each swing once</source>
        <translation>to jest ponownie pomiar z %1; oczekiwano każdego pomiaru raz</translation>
    </message>
    <message>
        <source>this swing is of %1, %2; expected the aircraft and compass of %3 (%4, %5)</source>
        <translation>ta dewiacja jest z %1, %2; oczekiwano statku powietrznego i busoli z %3 (%4, %5)</translation>
    </message>
    <message>
        <source>this is the swing of %1 once more, which is the first compass&apos;s; expected one of the second</source>
        <translation>to jest ponownie pomiar z %1, który należy do pierwszej busoli; oczekiwano pomiaru drugiej</translation>
    </message>
    <message>
        <source>this swing is of %1, that of %2 of %3; expected two compasses of one aircraft</source>
        <translation>ten pomiar jest z %1, a ten z %2 z %3; oczekiwano dwóch busol jednego statku powietrznego</translation>
    </message>
    <message>
        <source>this swing is of %1, %2, as that of %3 is; expected another compass of the aircraft</source>
        <translation>ten pomiar jest z %1, %2, tak jak ten z %3; oczekiwano innej busoli tego statku powietrznego</translation>
    </message>
    <message>
        <source>%1 does not say of which aircraft and compass it is: whether it is of the same one is not known</source>
        <translation>%1 nie mówi, z jakiego jest statku powietrznego i busoli: nie wiadomo, czy z tej samej</translation>
    </message>
    <message>
        <source>both compasses differ from the datum by %1° alike: the datum (variation, clock, line) may be out, or both moved; hold it against another</source>
        <translation>obie busole różnią się od wzorca tak samo, o %1°: może być zły wzorzec (deklinacja, zegar, linia) albo zmieniły się obie; porównaj z innym wzorcem</translation>
    </message>
    <message>
        <source>read together, %1 and %2 differ from the datum by %3° alike: the datum may have been out, or both moved</source>
        <translation>odczytane razem %1 i %2 różnią się od wzorca tak samo, o %3°: mógł być zły wzorzec albo zmieniły się obie</translation>
    </message>
    <message>
        <source>no error of a pair of headings is stated: %1° is taken, as they scatter</source>
        <translation>nie podano błędu pary kursów: przyjęto %1°, według ich rozrzutu</translation>
    </message>
    <message>
        <source>the compass reads the reciprocal: look whether it was read from the other side, or is mounted back to front</source>
        <translation>busola wskazuje kurs odwrotny: sprawdź, czy nie odczytano jej z drugiej strony albo nie zamontowano tyłem</translation>
    </message>
    <message>
        <source>the error of the headings changed on the way: in all they scatter %1 times as much as the first of them</source>
        <translation>błąd kursów zmienił się po drodze: wszystkie razem mają rozrzut %1 razy większy niż pierwsze</translation>
    </message>
    <message>
        <source>the innovations are %1 times what the stated errors allow: the error of the reference is stated wrongly, or it changed; alarms and standard errors are by the innovations where they are the larger</source>
        <translation>innowacje są %1 razy większe, niż pozwalają podane błędy: błąd odniesienia podano źle albo się zmienił; alarmy i błędy standardowe liczy się według innowacji, gdzie są większe</translation>
    </message>
    <message>
        <source>of the field only its size is known (%1), not its dip: no deviation can be computed with it; expected H_nT with dip_deg, or a place and date, in &quot;field&quot;</source>
        <translation>o polu wiadomo tylko, jak jest duże (%1), a nie jego inklinację: nie da się z nim obliczyć dewiacji; oczekiwano w &quot;field&quot; H_nT z dip_deg albo miejsca i daty</translation>
    </message>
    <message>
        <source>five coefficients do not describe this curve: neighbouring readings go astray together by some %1°, more than chance, and the card leaves it out (largest residual %2°)</source>
        <translation>pięć współczynników nie opisuje tej krzywej: sąsiednie odczyty odbiegają razem o około %1°, więcej niż przypadkiem, a tablica dewiacji to pomija (największe residuum %2°)</translation>
    </message>
    <message>
        <source>neither compass moved away from the other (%1 %); whether both moved alike is not told without a datum</source>
        <translation>żaden kompas nie odszedł od drugiego (%1 %); czy oba zmieniły się jednakowo, bez wzorca nie wiadomo</translation>
    </message>
    <message>
        <source>every reading is half a circle from the card: the compass or the datum was read from its other side; read them again before it is swung</source>
        <translation>każdy odczyt leży pół koła od tablicy: kompas albo wzorzec odczytano z drugiej strony; odczytać ponownie przed pomiarem</translation>
    </message>
    <message>
        <source>it was read on one heading only: what changed elsewhere is not seen, and the verdict rests on what compasses of its kind and history do</source>
        <translation>odczytano tylko na jednym kursie: zmian gdzie indziej nie widać, a werdykt opiera się na tym, co robią kompasy tego rodzaju i o takiej historii</translation>
    </message>
    <message>
        <source>a date of the calendar as YYYY-MM-DD or DD.MM.YYYY</source>
        <translation>data kalendarzowa w postaci RRRR-MM-DD albo DD.MM.RRRR</translation>
    </message>
    <message>
        <source>the legs do not tell the wind: they lie along one line, there and back; expected them all round, as 120° apart</source>
        <translation>odcinki nie określają wiatru: leżą na jednej linii, tam i z powrotem; oczekiwano odcinków dookoła, na przykład co 120°</translation>
    </message>
    <message>
        <source>one wind and one airspeed on all legs are assumed, and not all of it shows: 1 kt faster one way and 1 kt slower the other is taken for wind, and turns headings by up to %1°</source>
        <translation>przyjęto jeden wiatr i jedną prędkość na wszystkich odcinkach, a nie wszystko z tego widać: 1 kt szybciej w jedną stronę i 1 kt wolniej w drugą uchodzi za wiatr i obraca kursy nawet o %1°</translation>
    </message>
    <message>
        <source>the %1 aircraft have nothing in common that their own spread does not explain (B %2, C %3, 95 %): a constant error of the reference wind of up to %4 kt could pass unseen</source>
        <translation>%1 statków powietrznych nie ma nic wspólnego, czego nie tłumaczy ich własny rozrzut (B %2, C %3, 95 %): stały błąd wiatru odniesienia do %4 kt mógłby przejść niezauważony</translation>
    </message>
    <message>
        <source>the aircraft that the others are held against have B %1 and C %2 (95 %) in common, as a constant error of the reference wind of %3 kt would look: their headings being right, it is one</source>
        <translation>statki powietrzne, z którymi porównuje się pozostałe, mają wspólne B %1 i C %2 (95 %), tak jak wyglądałby stały błąd wiatru odniesienia %3 kt: skoro ich kursy są dobre, to on</translation>
    </message>
    <message>
        <source>the sine that the fleet has in common, B %1 and C %2 (95 %), is taken out: a deviation that all aircraft have goes with it</source>
        <translation>sinusoida wspólna dla floty, B %1 i C %2 (95 %), została odjęta: razem z nią odchodzi dewiacja, którą mają wszystkie statki powietrzne</translation>
    </message>
    <message>
        <source>the fleet has B %1 and C %2 (95 %) in common: a deviation of them all, or a constant error of the reference wind of %3 kt; these figures cannot tell which</source>
        <translation>flota ma wspólne B %1 i C %2 (95 %): dewiacja wszystkich albo stały błąd wiatru odniesienia %3 kt; z tych liczb nie wiadomo, które z dwojga</translation>
    </message>
    <message numerus="yes">
        <source>%n heading(s) indicated more than 30° off what was selected, %1° at %2°: read them again</source>
        <translation>
            <numerusform>%n kurs wskazany dalej niż 30° od nastawionego, %1° przy %2°: odczytać ponownie</numerusform>
            <numerusform>%n kursy wskazane dalej niż 30° od nastawionych, %1° przy %2°: odczytać ponownie</numerusform>
            <numerusform>%n kursów wskazanych dalej niż 30° od nastawionych, %1° przy %2°: odczytać ponownie</numerusform>
        </translation>
    </message>
    <message>
        <source>with %1° selected the headings indicate %2° more than table F1 after the adjustment; expected the same within 0.2°</source>
        <translation>przy nastawionych %1° tablica kursów wskazuje o %2° więcej niż tablica F1 po regulacji; oczekiwano zgodności do 0,2°</translation>
    </message>
    <message>
        <source>A is %1°: bearings of the sun that stand where those of its shadow are expected, or the reverse, make 180° of it; else the compass was read from its other side</source>
        <translation>A wynosi %1°: namiary słońca w miejscu namiarów jego cienia albo odwrotnie dają z tego 180°; w przeciwnym razie kompas odczytano z drugiej strony</translation>
    </message>
    <message>
        <source>A is %1°: a longitude of the other sign (%2° for %3°) makes %4° of it; east is positive</source>
        <translation>A wynosi %1°: długość geograficzna o przeciwnym znaku (%2° zamiast %3°) daje z tego %4°; wschodnia jest dodatnia</translation>
    </message>
    <message>
        <source>its date %1 is before there were aircraft; expected the day on which it was swung</source>
        <translation>jego data %1 jest sprzed czasów lotnictwa; oczekiwano dnia, w którym wykonano pomiar</translation>
    </message>
    <message>
        <source>the compass falls while the aircraft turns right: it reads %1 on %2 and %3 on %4, so that one reading stands for more than one heading; there is no card of it, and no slip is looked for</source>
        <translation>kompas cofa się, gdy statek powietrzny obraca się w prawo: wskazuje %1 na %2 i %3 na %4, więc jedno wskazanie odpowiada więcej niż jednemu kursowi; nie ma dla niego tablicy dewiacji i nie szuka się pomyłek</translation>
    </message>
    <message>
        <source>every reading is there %1 times with the same figures, as when a list is entered again: the errors are those of %2 readings, and a slip hides behind its copies; take the copies out</source>
        <translation>każdy odczyt występuje %1 razy z tymi samymi liczbami, jak przy ponownym wpisaniu listy: błędy są takie jak dla %2 odczytów, a pomyłka kryje się za kopiami; usunąć kopie</translation>
    </message>
    <message>
        <source>every compass heading is a multiple of %1°: taken as read to no better, whatever the compass can</source>
        <translation>każdy kurs kompasowy jest wielokrotnością %1°: przyjęto, że dokładniej nie odczytano, cokolwiek kompas potrafi</translation>
    </message>
    <message>
        <source>headings are reciprocal, 180° off</source>
        <translation>kursy są odwrotne, o 180°</translation>
    </message>
    <message>
        <source>headings are %1° off</source>
        <translation>kursy są przesunięte o %1°</translation>
    </message>
    <message>
        <source>headings run anticlockwise</source>
        <translation>kursy rosną przeciwnie do ruchu wskazówek zegara</translation>
    </message>
    <message>
        <source>pitch has the other sign (nose up is positive)</source>
        <translation>pochylenie ma przeciwny znak (dziób w górę jest dodatni)</translation>
    </message>
    <message>
        <source>roll has the other sign (starboard wing down is positive)</source>
        <translation>przechylenie ma przeciwny znak (prawe skrzydło w dół jest dodatnie)</translation>
    </message>
    <message>
        <source>pitch stands for roll and roll for pitch</source>
        <translation>pochylenie stoi w miejscu przechylenia, a przechylenie w miejscu pochylenia</translation>
    </message>
    <message>
        <source>%1: so taken the samples are explained to %2 nT, as stated to %3 nT</source>
        <translation>%1: tak wzięte próbki są wyjaśnione do %2 nT, tak jak podane do %3 nT</translation>
    </message>
    <message>
        <source>heading, pitch and roll explain %1 % of how the readings vary; expected %2 % or more: they are of another log or clock, or of another sign, order or unit</source>
        <translation>kurs, pochylenie i przechylenie wyjaśniają %1 % zmienności odczytów; oczekiwano co najmniej %2 %: pochodzą z innego zapisu lub zegara albo mają inny znak, kolejność lub jednostkę</translation>
    </message>
    <message>
        <source>the log&apos;s field is %1 nT, %2 % off the %3 nT that were given; expected within %4 %: another unit, another place, or a sensor of another scale, which soft iron then carries</source>
        <translation>pole w zapisie wynosi %1 nT, o %2 % inne niż podane %3 nT; oczekiwano do %4 %: inna jednostka, inne miejsce albo czujnik o innej skali, którą przejmuje wtedy żelazo miękkie</translation>
    </message>
    <message>
        <source>put the columns of the attitude right and calibrate once more</source>
        <translation>poprawić kolumny położenia i skalibrować ponownie</translation>
    </message>
    <message>
        <source>without pitch and roll the headings are those of a level compass, and this one was tilted: the field along z goes up and down by %1 % of the field; expected %2 % or less. Headings of it mean nothing, and there is no deviation map</source>
        <translation>bez pochylenia i przechylenia kursy są jak dla kompasu w poziomie, a ten był przechylony: pole wzdłuż z waha się o %1 % pola; oczekiwano najwyżej %2 %. Takie kursy nic nie znaczą i nie ma mapy dewiacji</translation>
    </message>
    <message>
        <source>more than one source: one dipole leaves %1 nT (rms), two leave %2 nT, at %3 and at %4 m; the errors reach to them. Take the stronger away, or read nearer to each</source>
        <translation>więcej niż jedno źródło: jeden dipol pozostawia %1 nT (rms), dwa pozostawiają %2 nT, w %3 i w %4 m; błędy sięgają do nich. Usunąć silniejsze albo odczytać bliżej każdego</translation>
    </message>
    <message>
        <source>what is left (%1 nT rms) is alike at neighbouring readings (correlation %2; expected %3 or less), so it is no noise: more than one source, a source that is no dipole from so near, or a field that is not uniform; the errors are %4 times as wide for it</source>
        <translation>to, co pozostaje (%1 nT rms), jest podobne w sąsiednich odczytach (korelacja %2; oczekiwano najwyżej %3), więc nie jest szumem: więcej niż jedno źródło, źródło, które z tak bliska nie jest dipolem, albo pole niejednorodne; błędy są przez to %4 razy szersze</translation>
    </message>
    <message>
        <source>that the sensor has no soft iron beyond this shape is taken for granted: what this log does not show of it may move the hard iron by up to %1 %2</source>
        <translation>przyjęto, że czujnik nie ma innego żelaza miękkiego niż w tym kształcie: to, czego ten zapis z niego nie pokazuje, może przesunąć żelazo twarde nawet o %1 %2</translation>
    </message>
    <message>
        <source>soft iron is in the log that these %1 parameters leave out: they leave %2 %4 of noise where all 10 leave %3 %4 (F %5; expected %6 or less), and they move the hard iron by %7 %4</source>
        <translation>w zapisie jest żelazo miękkie, które te %1 parametrów pomija: pozostawiają %2 %4 szumu tam, gdzie wszystkie 10 pozostawia %3 %4 (F %5; oczekiwano najwyżej %6), i przesuwają żelazo twarde o %7 %4</translation>
    </message>
    <message>
        <source>fit all 10 parameters (ellipsoid)</source>
        <translation>dopasować wszystkie 10 parametrów (elipsoida)</translation>
    </message>
    <message>
        <source>what the fit leaves over goes with the direction of the field: %1 %4 (rms) of it, %2 times as much as the scatter in one direction explains; expected %3 %4 or less: a sensor that is not linear, or a field that was not the same everywhere</source>
        <translation>to, co dopasowanie pozostawia, zależy od kierunku pola: %1 %4 (rms), %2 razy więcej niż tłumaczy rozrzut w jednym kierunku; oczekiwano najwyżej %3 %4: czujnik nieliniowy albo pole, które nie było wszędzie takie samo</translation>
    </message>
    <message numerus="yes">
        <source>%n spike(s) left out, the largest of %1 nT along %2 at %3 s: there for a sample alone; where one comes again as often as a thing is switched, it is that thing&apos;s</source>
        <translation>
            <numerusform>pominięto %n impuls, %1 nT wzdłuż %2 w %3 s: trwa jedną próbkę; jeżeli powraca przy każdym przełączeniu urządzenia, pochodzi od niego</numerusform>
            <numerusform>pominięto %n impulsy, największy %1 nT wzdłuż %2 w %3 s: trwają jedną próbkę; jeżeli powracają przy każdym przełączeniu urządzenia, pochodzą od niego</numerusform>
            <numerusform>pominięto %n impulsów, największy %1 nT wzdłuż %2 w %3 s: trwają jedną próbkę; jeżeli powracają przy każdym przełączeniu urządzenia, pochodzą od niego</numerusform>
        </translation>
    </message>
    <message>
        <source>a line stands at half the sampling rate (%1 Hz): the column goes up and down by %2 %3 from sample to sample, and what makes it may be stronger, as only a part of such a wave shows</source>
        <translation>prążek leży na połowie częstotliwości próbkowania (%1 Hz): kolumna waha się o %2 %3 z próbki na próbkę, a to, co go wywołuje, może być silniejsze, bo z takiej fali widać tylko część</translation>
    </message>
    <message>
        <source>perhaps %1 at %2 Hz</source>
        <translation>być może %1 przy %2 Hz</translation>
    </message>
    <message>
        <source>at %1 samples a second %2 Hz fall on %3 Hz: the field of such a supply would look like hard iron that drifts; calibrate with it off, or log at another rate</source>
        <translation>przy %1 próbkach na sekundę %2 Hz wypada na %3 Hz: pole takiego zasilania wyglądałoby jak dryfujące żelazo twarde; kalibrować przy wyłączonym albo zapisywać z inną częstotliwością</translation>
    </message>
    <message>
        <source>the measured columns look like µT</source>
        <translation>kolumny zmierzone wyglądają na µT</translation>
    </message>
    <message>
        <source>the measured columns look like mG</source>
        <translation>kolumny zmierzone wyglądają na mG</translation>
    </message>
    <message>
        <source>the measured columns look like G</source>
        <translation>kolumny zmierzone wyglądają na G</translation>
    </message>
    <message>
        <source>the applied columns look like µT</source>
        <translation>kolumny zadane wyglądają na µT</translation>
    </message>
    <message>
        <source>the applied columns look like mG</source>
        <translation>kolumny zadane wyglądają na mG</translation>
    </message>
    <message>
        <source>the applied columns look like G</source>
        <translation>kolumny zadane wyglądają na G</translation>
    </message>
    <message>
        <source>a column is in another unit, or is not that field</source>
        <translation>kolumna jest w innej jednostce albo nie jest tym polem</translation>
    </message>
    <message>
        <source>has %1 to %2 nT measured per nT applied; expected %3 to %4: %5</source>
        <translation>ma od %1 do %2 nT zmierzonych na nT zadany; oczekiwano od %3 do %4: %5</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>zgodnie z ruchem wskazówek zegara</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>przeciwnie do ruchu wskazówek zegara</translation>
    </message>
    <message>
        <source>no one way</source>
        <translation>w żadną jedną stronę</translation>
    </message>
    <message>
        <source>the rows of the first run go counter-clockwise and those of the second clockwise: expected the clockwise run first</source>
        <translation>wiersze pierwszego przebiegu biegną przeciwnie do ruchu wskazówek zegara, a drugiego zgodnie: oczekiwano najpierw przebiegu zgodnego</translation>
    </message>
    <message>
        <source>the rows of the run clockwise go %1 and those of the other %2: one way round nothing is compared; expected one run each way, rows in the order in which they were read</source>
        <translation>wiersze przebiegu zgodnego biegną %1, a drugiego %2: w jedną stronę nie ma czego porównać; oczekiwano po jednym przebiegu w każdą stronę, wierszy w kolejności odczytu</translation>
    </message>
    <message>
        <source>the run clockwise has no reading from %1 to %2: over these %3° nothing is compared; expected %4° or less between readings</source>
        <translation>przebieg zgodny nie ma odczytu od %1 do %2: na tych %3° niczego nie porównano; oczekiwano najwyżej %4° między odczytami</translation>
    </message>
    <message>
        <source>the run counter-clockwise has no reading from %1 to %2: over these %3° nothing is compared; expected %4° or less between readings</source>
        <translation>przebieg przeciwny nie ma odczytu od %1 do %2: na tych %3° niczego nie porównano; oczekiwano najwyżej %4° między odczytami</translation>
    </message>
    <message>
        <source>is in the state already, and would count twice; expected a log that was not taken yet</source>
        <translation>jest już w stanie i liczyłby się dwa razy; oczekiwano zapisu jeszcze nieprzyjętego</translation>
    </message>
    <message>
        <source>it begins with the readings of a log that is in the state already: what both of them hold counts twice</source>
        <translation>zaczyna się odczytami zapisu, który już jest w stanie: to, co jest w obu, liczy się dwa razy</translation>
    </message>
    <message>
        <source>it overlaps in time with a log that is in the state already: what both of them hold counts twice</source>
        <translation>nakłada się w czasie z zapisem, który już jest w stanie: to, co jest w obu, liczy się dwa razy</translation>
    </message>
    <message numerus="yes">
        <source>%n report(s) came long after later ones of their flight: a turn or a climb between them cannot be judged; sort the file by aircraft and time</source>
        <translation>
            <numerusform>%n meldunek przyszedł długo po późniejszych z tego lotu: zakrętu ani wznoszenia między nimi nie da się ocenić; posortować plik według statku powietrznego i czasu</numerusform>
            <numerusform>%n meldunki przyszły długo po późniejszych z tego lotu: zakrętu ani wznoszenia między nimi nie da się ocenić; posortować plik według statku powietrznego i czasu</numerusform>
            <numerusform>%n meldunków przyszło długo po późniejszych z tego lotu: zakrętu ani wznoszenia między nimi nie da się ocenić; posortować plik według statku powietrznego i czasu</numerusform>
        </translation>
    </message>
    <message>
        <source>the headings that are read are %1° from those flown: the other end of the needle, or a sensor that is mounted the wrong way round; it is to be turned before a table is made</source>
        <translation>odczytywane kursy są o %1° od lecianych: drugi koniec igły albo czujnik zamontowany odwrotnie; obrócić go, zanim powstanie tablica</translation>
    </message>
    <message>
        <source>the winds change by a factor of %1 between the flights %2 and %3, as knots and metres a second would; nothing is fitted until the file has one unit, or it is said that it has</source>
        <translation>wiatry zmieniają się %1 razy między lotami %2 i %3, jak węzły i metry na sekundę; niczego się nie dopasowuje, dopóki plik nie ma jednej jednostki albo nie powiedziano, że ją ma</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) were read on %1 different headings: those of the same ten degrees count as one, their mean</source>
        <translation>
            <numerusform>%n parę odczytano na %1 różnych kursach: pary z tych samych dziesięciu stopni liczą się jako jedna, ich średnia</numerusform>
            <numerusform>%n pary odczytano na %1 różnych kursach: pary z tych samych dziesięciu stopni liczą się jako jedna, ich średnia</numerusform>
            <numerusform>%n par odczytano na %1 różnych kursach: pary z tych samych dziesięciu stopni liczą się jako jedna, ich średnia</numerusform>
        </translation>
    </message>
    <message>
        <source>the pairs between %1° and %2° contradict each other by %3°: one is a slip, or a compass sticks; read them again</source>
        <translation>pary między %1° a %2° przeczą sobie o %3°: jedna jest pomyłką albo kompas się zacina; odczytać je ponownie</translation>
    </message>
    <message>
        <source>the readings on %1° contradict each other by %2°: one is a slip, or the compass sticks; read it again (their mean was taken)</source>
        <translation>odczyty na %1° przeczą sobie o %2°: jeden jest pomyłką albo kompas się zacina; odczytać ponownie (wzięto ich średnią)</translation>
    </message>
    <message numerus="yes">
        <source>%1° was read %n time(s): it counts as one reading, the mean</source>
        <translation>
            <numerusform>%1° odczytano %n raz: liczy się jako jeden odczyt, średnia</numerusform>
            <numerusform>%1° odczytano %n razy: liczy się jako jeden odczyt, średnia</numerusform>
            <numerusform>%1° odczytano %n razy: liczy się jako jeden odczyt, średnia</numerusform>
        </translation>
    </message>
    <message>
        <source>holds a text of more than %1 MiB; expected %2</source>
        <translation>zawiera tekst dłuższy niż %1 MiB; oczekiwano: %2</translation>
    </message>
</context>
<context>
    <name>db</name>
    <message>
        <source>this is a folder; expected a database file</source>
        <translation>to jest folder; oczekiwano pliku bazy danych</translation>
    </message>
    <message>
        <source>the file is empty; expected a Lubberline database</source>
        <translation>plik jest pusty; oczekiwano bazy Lubberline</translation>
    </message>
    <message>
        <source>there is no such database; expected an existing file</source>
        <translation>nie ma takiej bazy; oczekiwano istniejącego pliku</translation>
    </message>
    <message>
        <source>the folder %1 is not there; expected an existing one for the new database</source>
        <translation>nie ma folderu %1; dla nowej bazy oczekiwano istniejącego</translation>
    </message>
    <message>
        <source>the folder %1 may not be written; expected one that may</source>
        <translation>w folderze %1 nie wolno pisać; oczekiwano takiego, w którym wolno</translation>
    </message>
    <message>
        <source>this SQLite file was not made by Lubberline; expected a fleet database</source>
        <translation>tego pliku SQLite nie utworzył Lubberline; oczekiwano bazy floty</translation>
    </message>
    <message>
        <source>the database has schema %1, made by a newer Lubberline; this one knows schemas up to %2: update the program</source>
        <translation>baza ma schemat %1 z nowszej wersji Lubberline; ta zna schematy do %2: zaktualizuj program</translation>
    </message>
    <message>
        <source>the step to schema %1 (%2) failed, nothing was changed: %3</source>
        <translation>przejście do schematu %1 (%2) nie udało się, niczego nie zmieniono: %3</translation>
    </message>
    <message>
        <source>the database was not closed properly, and its folder may not be written; expected one that may, so that what was stored last can be recovered</source>
        <translation>bazy nie zamknięto poprawnie, a w jej folderze nie wolno pisać; oczekiwano takiego, w którym wolno, aby odzyskać ostatnie zapisy</translation>
    </message>
    <message>
        <source>there is an aircraft type of this name already; expected another</source>
        <translation>typ statku powietrznego o tej nazwie już istnieje; oczekiwano innej</translation>
    </message>
    <message>
        <source>there is an aircraft of this registration already; expected another</source>
        <translation>statek powietrzny o tych znakach już istnieje; oczekiwano innych</translation>
    </message>
    <message>
        <source>there is a compass of this name on this aircraft already; expected another</source>
        <translation>busola o tej nazwie już jest na tym statku powietrznym; oczekiwano innej</translation>
    </message>
    <message>
        <source>there is a site of this name already; expected another</source>
        <translation>miejsce o tej nazwie już istnieje; oczekiwano innej</translation>
    </message>
    <message>
        <source>there is a limits profile of this name already; expected another</source>
        <translation>zestaw wartości dopuszczalnych o tej nazwie już istnieje; oczekiwano innej</translation>
    </message>
    <message>
        <source>there is a record of this identity already; expected another</source>
        <translation>zapis o tym identyfikatorze już istnieje; oczekiwano innego</translation>
    </message>
    <message>
        <source>the swing is signed and frozen; expected a new revision instead of a change</source>
        <translation>pomiar jest podpisany i zamrożony; zamiast zmiany oczekiwano nowego wydania</translation>
    </message>
    <message>
        <source>%1; expected no change of it</source>
        <translation>%1; oczekiwano, że się nie zmieni</translation>
    </message>
    <message>
        <source>a value is outside its range; expected one that fits %1</source>
        <translation>wartość jest poza zakresem; oczekiwano zgodnej z %1</translation>
    </message>
    <message>
        <source>the record refers to another that is not in the database, or is still referred to</source>
        <translation>zapis odwołuje się do innego, którego nie ma w bazie, albo sam jest jeszcze potrzebny</translation>
    </message>
    <message>
        <source>something that is needed is not stated (%1); expected a value</source>
        <translation>brakuje czegoś potrzebnego (%1); oczekiwano wartości</translation>
    </message>
    <message>
        <source>the record contradicts another in the database (%1)</source>
        <translation>zapis przeczy innemu w bazie (%1)</translation>
    </message>
    <message>
        <source>another program is writing to the database; expected it to be free: close the other program or try again</source>
        <translation>inny program zapisuje do bazy; oczekiwano wolnej: zamknij go albo spróbuj ponownie</translation>
    </message>
    <message>
        <source>the database may only be read; expected a file and folder that may be written</source>
        <translation>bazę można tylko czytać; oczekiwano pliku i folderu do zapisu</translation>
    </message>
    <message>
        <source>the drive failed while the database was read or written (%1); expected a drive that is there</source>
        <translation>dysk zawiódł podczas czytania lub zapisu bazy (%1); oczekiwano dostępnego dysku</translation>
    </message>
    <message>
        <source>the database is damaged (%1); expected a whole one: restore a backup</source>
        <translation>baza jest uszkodzona (%1); oczekiwano całej: przywróć kopię zapasową</translation>
    </message>
    <message>
        <source>the drive is full; expected room for the database: free some space</source>
        <translation>dysk jest pełny; oczekiwano miejsca na bazę: zwolnij trochę</translation>
    </message>
    <message>
        <source>the database cannot be opened; expected a file in a folder that is there and may be read</source>
        <translation>nie można otworzyć bazy; oczekiwano pliku w istniejącym folderze, który wolno czytać</translation>
    </message>
    <message>
        <source>this is not a Lubberline database; expected an SQLite file made by this program</source>
        <translation>to nie jest baza Lubberline; oczekiwano pliku SQLite utworzonego przez ten program</translation>
    </message>
    <message>
        <source>the database refused (%1)</source>
        <translation>baza odmówiła (%1)</translation>
    </message>
    <message>
        <source>a number is not finite; expected a real figure</source>
        <translation>liczba nie jest skończona; oczekiwano rzeczywistej</translation>
    </message>
    <message>
        <source>there is no such %1 in the database</source>
        <translation>w bazie nie ma takiego wpisu: %1</translation>
    </message>
    <message>
        <source>a part of the change failed; nothing was stored</source>
        <translation>część zmiany nie udała się; niczego nie zapisano</translation>
    </message>
    <message>
        <source>due rule</source>
        <translation>reguła terminów</translation>
    </message>
    <message>
        <source>waiver</source>
        <translation>odstąpienie</translation>
    </message>
    <message>
        <source>the name of the rule</source>
        <translation>nazwa reguły</translation>
    </message>
    <message>
        <source>the name of who waives</source>
        <translation>nazwisko odstępującego</translation>
    </message>
    <message>
        <source>the reason of the waiver is empty; expected why no swing is needed</source>
        <translation>powód odstąpienia jest pusty; oczekiwano, dlaczego pomiar nie jest potrzebny</translation>
    </message>
    <message>
        <source>the waiver is on record already; a waiver is not changed</source>
        <translation>odstąpienie jest już w zapisie; odstąpienia się nie zmienia</translation>
    </message>
    <message>
        <source>event</source>
        <translation>zdarzenie</translation>
    </message>
    <message>
        <source>electrical swing</source>
        <translation>pomiar elektryczny</translation>
    </message>
    <message>
        <source>aircraft type</source>
        <translation>typ statku powietrznego</translation>
    </message>
    <message>
        <source>aircraft</source>
        <translation>statek powietrzny</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>fleet</source>
        <translation>flota</translation>
    </message>
    <message>
        <source>aircraft as %1</source>
        <translation>statek powietrzny jako %1</translation>
    </message>
    <message>
        <source>the name of the aircraft type</source>
        <translation>nazwa typu statku powietrznego</translation>
    </message>
    <message>
        <source>the registration</source>
        <translation>znaki rejestracyjne</translation>
    </message>
    <message>
        <source>the name of the compass</source>
        <translation>nazwa busoli</translation>
    </message>
    <message>
        <source>guided swing</source>
        <translation>pomiar prowadzony</translation>
    </message>
    <message>
        <source>the guided swing %1 does not read: %2</source>
        <translation>pomiaru prowadzonego %1 nie da się odczytać: %2</translation>
    </message>
    <message>
        <source>the guided swing is finished; nothing is added to it</source>
        <translation>pomiar prowadzony jest ukończony; niczego się do niego nie dodaje</translation>
    </message>
    <message>
        <source>this guided swing has gone on in another window (%1 steps there, %2 known here); nothing was overwritten: take it up again</source>
        <translation>ten pomiar prowadzony posunął się w innym oknie (tam kroków %1, tu znanych %2); niczego nie nadpisano: podejmij go ponownie</translation>
    </message>
    <message>
        <source>this %1 (%2) has been changed elsewhere; nothing was overwritten, look at it again</source>
        <translation>%1 (%2): zmieniono gdzie indziej; niczego nie nadpisano, obejrzyj ponownie</translation>
    </message>
    <message>
        <source>%1 is empty; expected a name</source>
        <translation>%1: puste; oczekiwano nazwy</translation>
    </message>
    <message>
        <source>sensor model</source>
        <translation>model czujnika</translation>
    </message>
    <message>
        <source>the name of the sensor model</source>
        <translation>nazwa modelu czujnika</translation>
    </message>
    <message>
        <source>a figure of the sensor model %1 is not a real number; expected finite ones</source>
        <translation>liczba modelu czujnika %1 nie jest rzeczywista; oczekiwano skończonych</translation>
    </message>
    <message>
        <source>%1: the states of its moving parts do not read: %2</source>
        <translation>%1: stanów części ruchomych nie da się odczytać: %2</translation>
    </message>
    <message>
        <source>the swing is %1 already; expected a draft</source>
        <translation>pomiar jest już w stanie: %1; oczekiwano szkicu</translation>
    </message>
    <message>
        <source>the swing is not complete: %1</source>
        <translation>pomiar nie jest ukończony: %1</translation>
    </message>
    <message>
        <source>the swing is signed and frozen; expected an amendment instead</source>
        <translation>pomiar jest podpisany i zamrożony; oczekiwano poprawki</translation>
    </message>
    <message>
        <source>the swing is a draft already; expected a complete one</source>
        <translation>pomiar jest już szkicem; oczekiwano ukończonego</translation>
    </message>
    <message>
        <source>the reason is empty; expected why a complete swing is opened again</source>
        <translation>powód jest pusty; oczekiwano, dlaczego ukończony pomiar otwiera się ponownie</translation>
    </message>
    <message>
        <source>the swing is a draft; expected a complete one: it is completed before it is signed</source>
        <translation>pomiar jest szkicem; oczekiwano ukończonego: podpisuje się po ukończeniu</translation>
    </message>
    <message>
        <source>the name is empty; expected who signs</source>
        <translation>nazwisko jest puste; oczekiwano, kto podpisuje</translation>
    </message>
    <message>
        <source>the swing is not signed; expected a signed one: anything else can be changed as it is</source>
        <translation>pomiar nie jest podpisany; oczekiwano podpisanego: inne można zmieniać wprost</translation>
    </message>
    <message>
        <source>the reason is empty; expected why the signed swing is amended</source>
        <translation>powód jest pusty; oczekiwano, dlaczego podpisany pomiar się poprawia</translation>
    </message>
    <message>
        <source>the swing is amended already by the record %1; expected that one to be changed or amended</source>
        <translation>pomiar poprawia już zapis %1; oczekiwano zmiany lub poprawki tamtego</translation>
    </message>
    <message>
        <source>the signed swing of %1 (record %2) is not what was signed</source>
        <translation>podpisany pomiar z %1 (zapis %2) nie jest tym, co podpisano</translation>
    </message>
    <message>
        <source>site</source>
        <translation>miejsce</translation>
    </message>
    <message>
        <source>limits profile</source>
        <translation>zestaw wartości dopuszczalnych</translation>
    </message>
    <message>
        <source>datum instrument</source>
        <translation>przyrząd odniesienia</translation>
    </message>
    <message>
        <source>the name of the site</source>
        <translation>nazwa miejsca</translation>
    </message>
    <message>
        <source>the name of the limits profile</source>
        <translation>nazwa zestawu wartości dopuszczalnych</translation>
    </message>
    <message>
        <source>the name of the instrument</source>
        <translation>nazwa przyrządu</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>pensacyjny</translation>
    </message>
    <message>
        <source>reading of the swing</source>
        <translation>odczyt pomiaru</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no record id; expected one, or its beginning, as `lubberline swings` lists them</source>
        <translation>„%1” nie jest identyfikatorem zapisu; oczekiwano identyfikatora lub jego początku, jak wymienia `lubberline swings`</translation>
    </message>
    <message>
        <source>there is no swing whose record id begins with %1</source>
        <translation>nie ma pomiaru o identyfikatorze zaczynającym się od %1</translation>
    </message>
    <message>
        <source>several swings have record ids that begin with %1; expected more of it</source>
        <translation>kilka pomiarów ma identyfikatory zaczynające się od %1; oczekiwano dłuższego</translation>
    </message>
    <message>
        <source>the state of a swing is no particular; expected it to be completed, opened again with a reason, or signed</source>
        <translation>stan pomiaru nie jest daną; oczekiwano ukończenia, ponownego otwarcia z powodem albo podpisu</translation>
    </message>
    <message>
        <source>somebody has signed this swing; it stays on record</source>
        <translation>ktoś podpisał ten pomiar; pozostaje w zapisie</translation>
    </message>
    <message>
        <source>only a draft can be removed; this swing is complete</source>
        <translation>usunąć można tylko szkic; ten pomiar jest ukończony</translation>
    </message>
    <message>
        <source>this reading has been changed elsewhere to: %1; nothing was overwritten, look at it again</source>
        <translation>ten odczyt zmieniono gdzie indziej na: %1; niczego nie nadpisano, obejrzyj ponownie</translation>
    </message>
    <message>
        <source>cancelled; nothing was exported</source>
        <translation>anulowano; niczego nie wyeksportowano</translation>
    </message>
    <message>
        <source>the guided swing of %1, %2, %3 has gone on here and elsewhere in different ways (record %4); nothing was stored</source>
        <translation>pomiar prowadzony %1, %2, %3 posunął się tu i gdzie indziej w różny sposób (zapis %4); niczego nie zapisano</translation>
    </message>
    <message>
        <source>the swing of %1, %2, %3 is in the database already with other contents (record %4); nothing was stored</source>
        <translation>pomiar %1, %2, %3 jest już w bazie z inną treścią (zapis %4); niczego nie zapisano</translation>
    </message>
    <message>
        <source>cancelled; nothing was stored</source>
        <translation>anulowano; niczego nie zapisano</translation>
    </message>
    <message>
        <source>integrity: %1</source>
        <translation>spójność: %1</translation>
    </message>
    <message>
        <source>order: two readings of the swing %1 are in one place</source>
        <translation>kolejność: dwa odczyty pomiaru %1 są w jednym miejscu</translation>
    </message>
    <message>
        <source>signature: %1</source>
        <translation>podpis: %1</translation>
    </message>
    <message>
        <source>results: the state kept for %1, %2 is not that of its latest swing</source>
        <translation>wyniki: zachowany stan %1, %2 nie odpowiada ostatniemu pomiarowi</translation>
    </message>
    <message>
        <source>results: those kept for the swing of %1 (record %2) are not what its readings give</source>
        <translation>wyniki: zachowane dla pomiaru z %1 (zapis %2) nie wynikają z jego odczytów</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>anulowano</translation>
    </message>
    <message>
        <source>there is a file of this name already; expected a new name for the backup</source>
        <translation>plik o tej nazwie już istnieje; oczekiwano nowej nazwy kopii</translation>
    </message>
    <message>
        <source>the backup could not be written to its place; expected a folder that may be written</source>
        <translation>kopii nie można było zapisać na miejsce; oczekiwano folderu do zapisu</translation>
    </message>
    <message>
        <source>status</source>
        <translation>stan</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos;</source>
        <translation>%1 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>entry %1 (%2, %3, record %4)</source>
        <translation>wpis %1 (%2, %3, zapis %4)</translation>
    </message>
    <message>
        <source>%1 was put in behind the program&apos;s back</source>
        <translation>%1 wstawiono z pominięciem programu</translation>
    </message>
    <message>
        <source>%1 does not follow the one before it: an entry was taken out, put in, changed or moved</source>
        <translation>%1 nie wynika z poprzedniego: wpis wyjęto, wstawiono, zmieniono lub przesunięto</translation>
    </message>
    <message>
        <source>%1 does not follow the entry before it of its record</source>
        <translation>%1 nie wynika z poprzedniego wpisu swojego zapisu</translation>
    </message>
    <message>
        <source>%1 is not what was written: it was changed</source>
        <translation>%1 nie jest tym, co zapisano: został zmieniony</translation>
    </message>
    <message>
        <source>%1 stands before the entry before it (%2): the clock had been set back</source>
        <translation>%1 stoi przed poprzednim wpisem (%2): zegar był cofnięty</translation>
    </message>
    <message>
        <source>the head of the audit trail is not that of its last entry, %1</source>
        <translation>głowa dziennika zmian nie należy do jego ostatniego wpisu, %1</translation>
    </message>
    <message>
        <source>the audit trail is chained from %1 on: the %2 entries before are as they were found then</source>
        <translation>dziennik zmian jest łańcuchem od %1: wcześniejsze wpisy (%2) są takie, jak je wtedy zastano</translation>
    </message>
    <message>
        <source>entry %1 is missing</source>
        <translation>brakuje wpisu %1</translation>
    </message>
    <message>
        <source>entries %1 to %2 are missing</source>
        <translation>brakuje wpisów od %1 do %2</translation>
    </message>
    <message>
        <source>the audit trail does not hold the head %1… of %2: it was cut off, or is another&apos;s</source>
        <translation>dziennik zmian nie ma głowy %1… z %2: ucięto go albo jest czyjś inny</translation>
    </message>
    <message>
        <source>%1 was changed, or the entry before it was taken out</source>
        <translation>%1 zmieniono albo wyjęto wpis przed nim</translation>
    </message>
    <message>
        <source>audit_head has no row; expected the head of the audit trail</source>
        <translation>audit_head nie ma wiersza; oczekiwano głowy dziennika zmian</translation>
    </message>
    <message>
        <source>the database has the old schema %1 and may only be read, and no copy could be made to bring up to date; expected room for one among the temporary files</source>
        <translation>baza ma stary schemat %1 i można ją tylko czytać, a nie udało się zrobić kopii do uaktualnienia; oczekiwano na nią miejsca wśród plików tymczasowych</translation>
    </message>
    <message>
        <source>the database has the old schema %1; it was read as a copy and stays as it is</source>
        <translation>baza ma stary schemat %1; odczytano jej kopię, a ona zostaje bez zmian</translation>
    </message>
    <message>
        <source>nothing was changed: before the database is brought up to date a copy is made, and it failed: %1</source>
        <translation>niczego nie zmieniono: przed uaktualnieniem bazy robi się kopię, a to się nie udało: %1</translation>
    </message>
    <message>
        <source>the database was brought from schema %1 to %2; a copy as it was stands in %3</source>
        <translation>bazę uaktualniono ze schematu %1 do %2; kopia poprzedniej jest w %3</translation>
    </message>
    <message>
        <source>nothing (NULL)</source>
        <translation>nic (NULL)</translation>
    </message>
    <message>
        <source>an infinite number</source>
        <translation>liczba nieskończona</translation>
    </message>
    <message>
        <source>a block of %1 bytes</source>
        <translation>blok %1 bajtów</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>liczba całkowita od %1 do %2</translation>
    </message>
    <message>
        <source>%1: %2 is stored; expected %3</source>
        <translation>%1: zapisano %2; oczekiwano %3</translation>
    </message>
    <message>
        <source>%1 does not read: %2</source>
        <translation>%1 nie daje się odczytać: %2</translation>
    </message>
    <message>
        <source>a text of at most %1 bytes</source>
        <translation>tekst najwyżej %1 bajtów</translation>
    </message>
    <message>
        <source>a text that is not empty</source>
        <translation>tekst niepusty</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>tekst</translation>
    </message>
    <message>
        <source>a record id (UUID in lower case with hyphens)</source>
        <translation>identyfikator zapisu (UUID małymi literami z łącznikami)</translation>
    </message>
    <message>
        <source>a day of the calendar as YYYY-MM-DD</source>
        <translation>dzień kalendarza jak RRRR-MM-DD</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>liczba całkowita</translation>
    </message>
    <message>
        <source>the number of a row</source>
        <translation>numer wiersza</translation>
    </message>
    <message>
        <source>the program gpg is not there; expected it to be installed (on Debian: apt install gpg)</source>
        <translation>nie ma programu gpg; oczekiwano, że jest zainstalowany (w Debianie: apt install gpg)</translation>
    </message>
    <message>
        <source>gpg failed (%1)</source>
        <translation>gpg zawiódł (%1)</translation>
    </message>
    <message>
        <source>cancelled; nothing was signed</source>
        <translation>anulowano; niczego nie podpisano</translation>
    </message>
    <message>
        <source>gpg did not answer within %1 s; expected a pass phrase, or a card that is there</source>
        <translation>gpg nie odpowiedział w ciągu %1 s; oczekiwano hasła albo włożonej karty</translation>
    </message>
    <message>
        <source>the key ring has no key %1; expected one of `gpg --list-keys`</source>
        <translation>w pęku kluczy nie ma klucza %1; oczekiwano jednego z `gpg --list-keys`</translation>
    </message>
    <message>
        <source>there is no OpenPGP public key in it; expected what `gpg --armor --export` writes</source>
        <translation>nie ma w nim klucza publicznego OpenPGP; oczekiwano tego, co zapisuje `gpg --armor --export`</translation>
    </message>
    <message>
        <source>no folder for a while could be made; expected room on the drive for temporary files</source>
        <translation>nie udało się utworzyć folderu tymczasowego; oczekiwano miejsca na dysku na pliki tymczasowe</translation>
    </message>
    <message>
        <source>the key %1 was revoked</source>
        <translation>klucz %1 został unieważniony</translation>
    </message>
    <message>
        <source>the key %1 had expired on %2, before it signed on %3</source>
        <translation>klucz %1 wygasł %2, zanim podpisano nim %3</translation>
    </message>
    <message>
        <source>key not known: %1, which calls itself %2</source>
        <translation>klucz nieznany: %1, podaje się za %2</translation>
    </message>
    <message>
        <source>the key %1 is %2&apos;s, and the name is %3</source>
        <translation>klucz %1 należy do %2, a nazwisko to %3</translation>
    </message>
    <message>
        <source>verified by the key %1 of %2</source>
        <translation>sprawdzono kluczem %1, który należy do %2</translation>
    </message>
    <message>
        <source>name not verified</source>
        <translation>nazwiska nie sprawdzono</translation>
    </message>
    <message>
        <source>it names the key %1 and carries no signature by it</source>
        <translation>podaje klucz %1, lecz nie ma jego podpisu</translation>
    </message>
    <message>
        <source>the key was not checked: %1</source>
        <translation>klucza nie sprawdzono: %1</translation>
    </message>
    <message>
        <source>the signature by the key %1 is not over what stands here</source>
        <translation>podpis kluczem %1 nie dotyczy tego, co tu stoi</translation>
    </message>
    <message>
        <source>head of the audit trail</source>
        <translation>głowa dziennika zmian</translation>
    </message>
    <message>
        <source>%1.%2, row %3: %4</source>
        <translation>%1.%2, wiersz %3: %4</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no fingerprint; expected 40 or 64 capital hexadecimal digits</source>
        <translation>&apos;%1&apos; nie jest odciskiem klucza; oczekiwano 40 lub 64 wielkich cyfr szesnastkowych</translation>
    </message>
    <message>
        <source>the name is empty; expected whose key it is, as he signs</source>
        <translation>nazwisko jest puste; oczekiwano nazwiska właściciela klucza, tak jak podpisuje</translation>
    </message>
    <message>
        <source>this key is known as that of %1; expected it to be removed first</source>
        <translation>ten klucz jest już znany jako klucz %1; oczekiwano najpierw jego usunięcia</translation>
    </message>
    <message>
        <source>no key of the station ends in %1; expected eight digits or more of one</source>
        <translation>żaden klucz stacji nie kończy się na %1; oczekiwano co najmniej ośmiu cyfr</translation>
    </message>
    <message>
        <source>several keys end in %1; expected more of it</source>
        <translation>kilka kluczy kończy się na %1; oczekiwano dłuższej części</translation>
    </message>
    <message>
        <source>the signature of %1 (%2) on the swing of %3 (record %4)</source>
        <translation>podpis %1 (%2) pod pomiarem z %3 (zapis %4)</translation>
    </message>
    <message>
        <source>%1 is not in the audit trail: it was put in, or its fields were changed</source>
        <translation>%1 nie występuje w dzienniku zmian: wstawiono go albo zmieniono jego pola</translation>
    </message>
    <message>
        <source>%1 has another time than its entry in the audit trail, %2</source>
        <translation>%1 ma inny czas niż jego wpis w dzienniku zmian, %2</translation>
    </message>
    <message>
        <source>the signature &quot;%1&quot;, which the audit trail names at %2, is not there: it was taken out or changed (swing of %3, record %4)</source>
        <translation>nie ma podpisu „%1”, który dziennik zmian podaje pod %2: wyjęto go lub zmieniono (pomiar z %3, zapis %4)</translation>
    </message>
    <message>
        <source>%1 does not hold: %2 was &quot;%3&quot; when it was signed and is &quot;%4&quot;</source>
        <translation>%1 nie jest ważny: %2 przy podpisaniu było „%3”, a jest „%4”</translation>
    </message>
    <message>
        <source>%1 does not hold: it, one before it, or the swing is not what was signed</source>
        <translation>%1 nie jest ważny: on, wcześniejszy podpis albo pomiar nie jest tym, co podpisano</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>the swing of %1 (record %2) is signed, and the audit trail does not say by whom</source>
        <translation>pomiar z %1 (zapis %2) jest podpisany, a dziennik zmian nie mówi, przez kogo</translation>
    </message>
    <message>
        <source>the swing of %1 (record %2) was signed by two people and is not frozen</source>
        <translation>pomiar z %1 (zapis %2) podpisały dwie osoby, a nie jest zamrożony</translation>
    </message>
    <message>
        <source>64 hexadecimal digits (SHA-256)</source>
        <translation>64 cyfry szesnastkowe (SHA-256)</translation>
    </message>
    <message>
        <source>the swing was changed while it was being signed; look at it again and sign anew</source>
        <translation>pomiar zmieniono podczas podpisywania; obejrzyj go jeszcze raz i podpisz na nowo</translation>
    </message>
    <message>
        <source>the swing is not signed; only a signed card can be printed again</source>
        <translation>pomiar nie jest podpisany; ponownie drukować można tylko podpisaną tablicę</translation>
    </message>
    <message>
        <source>a text of a reading has %1 bytes; expected at most %2</source>
        <translation>tekst odczytu ma %1 bajtów; oczekiwano najwyżej %2</translation>
    </message>
    <message>
        <source>swing.site_id, row %1: %2 is stored; expected the number of a site</source>
        <translation>swing.site_id, wiersz %1: zapisano %2; oczekiwano numeru miejsca</translation>
    </message>
    <message>
        <source>%1 of the record %2 refers to a row that is not there; expected a whole database: `lubberline db verify` lists what is wrong</source>
        <translation>%1 zapisu %2 wskazuje na wiersz, którego nie ma; oczekiwano całej bazy: `lubberline db verify` wymienia, co jest nie tak</translation>
    </message>
    <message>
        <source>the signed swing of %1, %2, %3 (record %4) is not what was signed; expected one whose signatures hold. Nothing was stored</source>
        <translation>podpisany pomiar z %1, %2, %3 (zapis %4) nie jest tym, co podpisano; oczekiwano takiego, którego podpisy są ważne. Niczego nie zapisano</translation>
    </message>
    <message>
        <source>the swing of %1, %2, %3 (record %4): %5</source>
        <translation>pomiar z %1, %2, %3 (zapis %4): %5</translation>
    </message>
    <message>
        <source>signed as %1 &quot;%2&quot;, in the file it is &quot;%3&quot;</source>
        <translation>podpisano jako %1 „%2”, w pliku jest „%3”</translation>
    </message>
    <message>
        <source>the signature of %1 does not hold</source>
        <translation>podpis %1 nie jest ważny</translation>
    </message>
    <message>
        <source>signed as %1 &quot;%2&quot;, here it is &quot;%3&quot;</source>
        <translation>podpisano jako %1 „%2”, tutaj jest „%3”</translation>
    </message>
    <message>
        <source>the file has the old schema %1, in which the audit trail is no chain; it was read as a copy</source>
        <translation>plik ma stary schemat %1, w którym dziennik zmian nie jest łańcuchem; odczytano jego kopię</translation>
    </message>
    <message>
        <source>foreign key: a row of %1 (%2) refers to a missing row of %3</source>
        <translation>klucz obcy: wiersz %1 (%2) wskazuje na brakujący wiersz %3</translation>
    </message>
    <message>
        <source>audit trail: %1</source>
        <translation>dziennik zmian: %1</translation>
    </message>
    <message>
        <source>the copy is written, but the database is damaged and the copy is as damaged (%1 findings; the first: %2); expected a whole one: `lubberline db verify` lists them</source>
        <translation>kopię zapisano, lecz baza jest uszkodzona i kopia tak samo (usterek: %1; pierwsza: %2); oczekiwano całej: `lubberline db verify` wymienia wszystkie</translation>
    </message>
    <message>
        <source>the backup is damaged: %1</source>
        <translation>kopia zapasowa jest uszkodzona: %1</translation>
    </message>
    <message>
        <source>the database may only be read; expected one that may be replaced</source>
        <translation>bazę można tylko czytać; oczekiwano takiej, którą można zastąpić</translation>
    </message>
    <message>
        <source>this is the database itself; expected a backup of it</source>
        <translation>to jest sama baza; oczekiwano jej kopii zapasowej</translation>
    </message>
    <message>
        <source>there is a file of this name already; expected a new name for the database as it is now</source>
        <translation>jest już plik o tej nazwie; oczekiwano nowej nazwy dla obecnej bazy</translation>
    </message>
    <message>
        <source>the database could not be put aside; expected a folder that may be written</source>
        <translation>nie udało się odłożyć bazy na bok; oczekiwano folderu, w którym wolno pisać</translation>
    </message>
    <message>
        <source>the backup could not be put in the place of the database; expected a folder that may be written</source>
        <translation>nie udało się umieścić kopii zapasowej na miejscu bazy; oczekiwano folderu, w którym wolno pisać</translation>
    </message>
    <message>
        <source>the swing of %1 in it is signed and stays on record; what has something signed cannot be removed</source>
        <translation>jego pomiar z %1 jest podpisany i pozostaje w zapisach; niczego z podpisem nie można usunąć</translation>
    </message>
    <message>
        <source>the swing of %1 in it is complete; open it again, or it stays on record</source>
        <translation>jego pomiar z %1 jest ukończony; otwórz go ponownie albo pozostanie w zapisach</translation>
    </message>
    <message>
        <source>%1 has signed a swing in it, which stays on record; what has something signed cannot be removed</source>
        <translation>%1 podpisał w nim pomiar, który pozostaje w zapisach; niczego z podpisem nie można usunąć</translation>
    </message>
    <message>
        <source>a waiver of %1 in it is signed and stays on record; what has something signed cannot be removed</source>
        <translation>jego odstąpienie z %1 jest podpisane i pozostaje w zapisach; niczego z podpisem nie można usunąć</translation>
    </message>
    <message>
        <source>the record that is to be removed is gone already</source>
        <translation>zapis do usunięcia już nie istnieje</translation>
    </message>
    <message>
        <source>line %1: %2 is no %3 in the database; what is known of it is left as it is</source>
        <translation>wiersz %1: %2 nie jest w bazie jako %3; to, co o nim wiadomo, pozostaje bez zmian</translation>
    </message>
    <message>
        <source>a swing of this import (%1) was changed since; nothing was undone</source>
        <translation>pomiar z tego wczytania (%1) od tego czasu zmieniono; niczego nie cofnięto</translation>
    </message>
    <message>
        <source>%1 · %2: D is %3° in %4 of %5 swings (the first in line %6) where its siblings have %7°: the sign of these records is suspect; nothing is turned</source>
        <translation>%1 · %2: D wynosi %3° w %4 z %5 pomiarów (pierwszy w wierszu %6), gdzie siostrzane mają %7°: znak tych zapisów jest podejrzany; niczego nie odwrócono</translation>
    </message>
    <message>
        <source>this is a pipe or a device; expected a database file</source>
        <translation>to potok lub urządzenie; oczekiwano pliku bazy danych</translation>
    </message>
    <message>
        <source>cancelled: gpg had not answered yet</source>
        <translation>anulowano: gpg jeszcze nie odpowiedział</translation>
    </message>
    <message>
        <source>cancelled: the keys of the signatures were not checked</source>
        <translation>anulowano: kluczy podpisów nie sprawdzono</translation>
    </message>
    <message>
        <source>the record %1, of which the audit trail says last &quot;%2&quot; at %3, is not there: it was taken out behind the program&apos;s back</source>
        <translation>nie ma zapisu %1, o którym dziennik zmian mówi ostatnio „%2” o %3: wyjęto go z pominięciem programu</translation>
    </message>
    <message>
        <source>%1, row %2: the audit trail does not know the record %3: it was put in behind the program&apos;s back</source>
        <translation>%1, wiersz %2: dziennik zmian nie zna zapisu %3: wstawiono go z pominięciem programu</translation>
    </message>
    <message>
        <source>the key %1 of %2 is not what the audit trail says: it was put in, or given to another, behind the program&apos;s back</source>
        <translation>klucz %1, który należy do %2, nie jest tym, co mówi dziennik zmian: wstawiono go lub przypisano innemu z pominięciem programu</translation>
    </message>
    <message>
        <source>the key %1 (%2) is not there, and the audit trail does not say that it was removed</source>
        <translation>nie ma klucza %1 (%2), a dziennik zmian nie mówi, że go usunięto</translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) in draft, the first in line %1: %2</source>
        <translation>
            <numerusform>%n dewiacja jako szkic, pierwsza w wierszu %1: %2</numerusform>
            <numerusform>%n dewiacje jako szkic, pierwsza w wierszu %1: %2</numerusform>
            <numerusform>%n dewiacji jako szkic, pierwsza w wierszu %1: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>suspect of the other sign as well: the records of %n more compass system(s)</source>
        <translation>
            <numerusform>podejrzane o przeciwny znak są też zapisy %n innego układu busoli</numerusform>
            <numerusform>podejrzane o przeciwny znak są też zapisy %n innych układów busoli</numerusform>
            <numerusform>podejrzane o przeciwny znak są też zapisy %n innych układów busoli</numerusform>
        </translation>
    </message>
    <message>
        <source>a moment of UTC as YYYY-MM-DDTHH:MM:SSZ</source>
        <translation>chwila UTC jako RRRR-MM-DDTGG:MM:SSZ</translation>
    </message>
    <message>
        <source>40 or 64 capital hexadecimal digits</source>
        <translation>40 lub 64 wielkie cyfry szesnastkowe</translation>
    </message>
    <message>
        <source>the time of a reading, %1, is no moment; expected UTC as YYYY-MM-DDTHH:MM:SSZ</source>
        <translation>czas odczytu, %1, nie jest chwilą; oczekiwano UTC jako RRRR-MM-DDTGG:MM:SSZ</translation>
    </message>
    <message>
        <source>the head of the audit trail says that %1 entries were there when it was begun; expected no more than its %2</source>
        <translation>głowa dziennika zmian podaje, że przy jej założeniu było %1 wpisów; oczekiwano nie więcej niż jej %2</translation>
    </message>
    <message>
        <source>the swing of %1 (record %2): its readings were changed last and its results are not computed since; the next program that opens this file to write does it</source>
        <translation>dewiacja z %1 (zapis %2): jej odczyty zmieniono jako ostatnie i od tego czasu nie obliczono wyników; zrobi to następny program, który otworzy ten plik do zapisu</translation>
    </message>
    <message>
        <source>coil bench</source>
        <translation>pomiar na stanowisku z cewkami</translation>
    </message>
    <message>
        <source>the swing is not complete: %1; if it was that day, say how it is known</source>
        <translation>dewiacja nie jest kompletna: %1; jeśli był to ten dzień, podaj, skąd to wiadomo</translation>
    </message>
    <message>
        <source>the swing of %1 (record %2) came with an import as a signed one, and the file does not say by whom: it is printed as not signed</source>
        <translation>pomiar z %1 (zapis %2) przyszedł z importem jako podpisany, a plik nie mówi przez kogo: drukuje się jako niepodpisany</translation>
    </message>
    <message>
        <source>the file has it as signed and does not say by whom; it is printed as not signed</source>
        <translation>plik podaje go jako podpisany i nie mówi przez kogo; drukuje się jako niepodpisany</translation>
    </message>
    <message>
        <source>the swing is frozen as a signed one, and nobody&apos;s signature is there; expected an amendment, which can be signed</source>
        <translation>pomiar jest zamrożony jako podpisany, a niczyjego podpisu nie ma; oczekiwano poprawki, którą można podpisać</translation>
    </message>
    <message>
        <source>line %1: %2 and %3 are perhaps one aircraft, written in two ways; they are taken as two</source>
        <translation>wiersz %1: %2 i %3 to być może jeden statek powietrzny zapisany na dwa sposoby; przyjęto dwa</translation>
    </message>
    <message>
        <source>line %1: %2 is a %3 here, and a %4 above; it is taken as the first</source>
        <translation>wiersz %1: %2 to tutaj %3, a wyżej %4; przyjęto to, co wyżej</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::AircraftPage</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>&amp;Aircraft</source>
        <translation>S&amp;tatek powietrzny</translation>
    </message>
    <message>
        <source>E&amp;vents</source>
        <translation>&amp;Zdarzenia</translation>
    </message>
    <message>
        <source>Registration:</source>
        <translation>Znaki rejestracyjne:</translation>
    </message>
    <message>
        <source>an aircraft must have a registration or tail number</source>
        <translation>statek powietrzny musi mieć znaki rejestracyjne lub numer boczny</translation>
    </message>
    <message>
        <source>Serial number:</source>
        <translation>Numer seryjny:</translation>
    </message>
    <message>
        <source>Operator:</source>
        <translation>Użytkownik:</translation>
    </message>
    <message>
        <source>Built:</source>
        <translation>Rok budowy:</translation>
    </message>
    <message>
        <source>Based at:</source>
        <translation>Miejsce bazowania:</translation>
    </message>
    <message>
        <source>A compass base of this database: where another is, the swing is due when the compass is predicted to leave its limits there</source>
        <translation>Krąg dewiacyjny z tej bazy danych: po zmianie miejsca bazowania pomiar dewiacji jest wymagany, gdy według prognozy busola przekroczy tam wartości dopuszczalne</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <source>Show:</source>
        <translation>Pokaż:</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nazwa:</translation>
    </message>
    <message>
        <source>a compass must have a name, as “standby compass”</source>
        <translation>busola musi mieć nazwę, na przykład „busola zapasowa”</translation>
    </message>
    <message>
        <source>Kind:</source>
        <translation>Rodzaj:</translation>
    </message>
    <message>
        <source>Compensator:</source>
        <translation>Kompensator:</translation>
    </message>
    <message>
        <source>Limits:</source>
        <translation>Dopuszczalne:</translation>
    </message>
    <message>
        <source>none set</source>
        <translation>nie ustalono</translation>
    </message>
    <message>
        <source>Resolution (°):</source>
        <translation>Działka odczytu (°):</translation>
    </message>
    <message>
        <source>Maker:</source>
        <translation>Producent:</translation>
    </message>
    <message>
        <source>Part number:</source>
        <translation>Numer części:</translation>
    </message>
    <message>
        <source>Installed on:</source>
        <translation>Zabudowana dnia:</translation>
    </message>
    <message>
        <source>Location:</source>
        <translation>Położenie:</translation>
    </message>
    <message>
        <source>Swings</source>
        <translation>Pomiary dewiacji</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Etap</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Largest (°)</source>
        <translation>Największa (°)</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Swings of this compass, newest first. Enter or double click opens one.</source>
        <translation>Pomiary dewiacji tej busoli, od najnowszego. Enter lub dwukrotne kliknięcie otwiera pomiar.</translation>
    </message>
    <message>
        <source>%1 · </source>
        <translation>%1 · </translation>
    </message>
    <message>
        <source> · DEMONSTRATION</source>
        <translation> · DANE POKAZOWE</translation>
    </message>
    <message>
        <source>%1 (swings: %2)</source>
        <translation>%1 (pomiary: %2)</translation>
    </message>
    <message>
        <source>there is no compass base %1; expected one of: %2</source>
        <translation>nie ma kręgu dewiacyjnego %1; oczekiwano jednego z: %2</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Statek powietrzny</translation>
    </message>
    <message>
        <source>Particulars, compasses and events of an aircraft at the left, the swings of the chosen compass and its coefficients over the years at the right. Enter opens the swing that is marked. Record lightning strikes, engine changes and the like as events: what is due follows from them.</source>
        <translation>Po lewej dane, busole i zdarzenia statku powietrznego, po prawej pomiary wybranej busoli i jej współczynniki w kolejnych latach. Enter otwiera zaznaczony pomiar. Uderzenia pioruna, wymiany silnika i podobne zapisuj jako zdarzenia: z nich wynika, co jest do wykonania.</translation>
    </message>
    <message>
        <source>Compasses of this aircraft</source>
        <translation>Busole tego statku powietrznego</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Busola</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Terminy</translation>
    </message>
    <message>
        <source>No compass is entered yet</source>
        <translation>Nie wprowadzono jeszcze busoli</translation>
    </message>
    <message>
        <source>&amp;Compass</source>
        <translation>&amp;Kompas</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::AssumedIronForm</name>
    <message>
        <source>Soft iron c, f:</source>
        <translation>Żelazo miękkie c, f:</translation>
    </message>
    <message>
        <source>Hard iron P, Q (nT):</source>
        <translation>Żelazo twarde P, Q (nT):</translation>
    </message>
    <message>
        <source>Compensating magnets (nT):</source>
        <translation>Magnesy kompensujące (nT):</translation>
    </message>
    <message>
        <source>One cycle of the compass (°):</source>
        <translation>Błąd półokrężny busoli (°):</translation>
    </message>
    <message>
        <source>How large it may be (a standard deviation), where the swing cannot tell: the band and the verdict rest on it</source>
        <translation>Jak duże może być (odchylenie standardowe) tam, gdzie pomiar tego nie określa: na tym opierają się pasmo i ocena</translation>
    </message>
    <message>
        <source>%1 %2 is no size; expected a number above 0, %3 at most</source>
        <translation>%1 %2 nie jest wielkością; oczekiwano liczby większej od 0, najwyżej %3</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::AuditWords</name>
    <message>
        <source>swing made</source>
        <translation>utworzono pomiar</translation>
    </message>
    <message>
        <source>particulars changed</source>
        <translation>zmieniono dane</translation>
    </message>
    <message>
        <source>swing removed</source>
        <translation>usunięto pomiar</translation>
    </message>
    <message>
        <source>reading added</source>
        <translation>dodano odczyt</translation>
    </message>
    <message>
        <source>reading changed</source>
        <translation>zmieniono odczyt</translation>
    </message>
    <message>
        <source>reading removed</source>
        <translation>usunięto odczyt</translation>
    </message>
    <message>
        <source>readings put in</source>
        <translation>wstawiono odczyty</translation>
    </message>
    <message>
        <source>marked complete</source>
        <translation>oznaczono jako ukończony</translation>
    </message>
    <message>
        <source>opened again</source>
        <translation>otwarto ponownie</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>podpisany</translation>
    </message>
    <message>
        <source>signed, and imported so</source>
        <translation>podpisano i tak wczytano</translation>
    </message>
    <message>
        <source>signed before the trail was a chain</source>
        <translation>podpisano, zanim dziennik stał się łańcuchem</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>zamrożono</translation>
    </message>
    <message>
        <source>amended: a new revision</source>
        <translation>poprawiono: nowe wydanie</translation>
    </message>
    <message>
        <source>guided swing begun</source>
        <translation>zaczęto pomiar prowadzony</translation>
    </message>
    <message>
        <source>guided swing finished</source>
        <translation>ukończono pomiar prowadzony</translation>
    </message>
    <message>
        <source>guided swing abandoned</source>
        <translation>przerwano pomiar prowadzony</translation>
    </message>
    <message>
        <source>nominal heading</source>
        <translation>kurs nominalny</translation>
    </message>
    <message>
        <source>magnetic heading</source>
        <translation>kurs magnetyczny</translation>
    </message>
    <message>
        <source>compass heading</source>
        <translation>kurs kompasowy</translation>
    </message>
    <message>
        <source>true heading</source>
        <translation>kurs rzeczywisty</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>pochylenie</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>przechylenie</translation>
    </message>
    <message>
        <source>left out because</source>
        <translation>pominięto, ponieważ</translation>
    </message>
    <message>
        <source>note</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <source>site</source>
        <translation>miejsce</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>rodzaj</translation>
    </message>
    <message>
        <source>stage</source>
        <translation>etap</translation>
    </message>
    <message>
        <source>state</source>
        <translation>stan</translation>
    </message>
    <message>
        <source>radio</source>
        <translation>radio</translation>
    </message>
    <message>
        <source>engines</source>
        <translation>silniki</translation>
    </message>
    <message>
        <source>electrics</source>
        <translation>odbiorniki elektryczne</translation>
    </message>
    <message>
        <source>further configuration</source>
        <translation>dalsza konfiguracja</translation>
    </message>
    <message>
        <source>datum instrument</source>
        <translation>przyrząd odniesienia</translation>
    </message>
    <message>
        <source>serial number of the datum</source>
        <translation>numer seryjny wzorca</translation>
    </message>
    <message>
        <source>datum calibrated until</source>
        <translation>wzorzec sprawdzony do</translation>
    </message>
    <message>
        <source>datum read by</source>
        <translation>wzorzec odczytał</translation>
    </message>
    <message>
        <source>compass read by</source>
        <translation>busolę odczytał</translation>
    </message>
    <message>
        <source>adjusted by</source>
        <translation>regulował</translation>
    </message>
    <message>
        <source>inspected by</source>
        <translation>sprawdził</translation>
    </message>
    <message>
        <source>variation (°, E +)</source>
        <translation>deklinacja (°, E +)</translation>
    </message>
    <message>
        <source>procedure</source>
        <translation>metoda</translation>
    </message>
    <message>
        <source>work order</source>
        <translation>zlecenie</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>powód</translation>
    </message>
    <message>
        <source>A taken out (°)</source>
        <translation>odjęte A (°)</translation>
    </message>
    <message>
        <source>weather</source>
        <translation>pogoda</translation>
    </message>
    <message>
        <source>why on this site</source>
        <translation>dlaczego w tym miejscu</translation>
    </message>
    <message>
        <source>how the datum is read</source>
        <translation>jak odczytuje się wzorzec</translation>
    </message>
    <message>
        <source>begun (UTC)</source>
        <translation>rozpoczęto (UTC)</translation>
    </message>
    <message>
        <source>ended (UTC)</source>
        <translation>zakończono (UTC)</translation>
    </message>
    <message>
        <source>field model</source>
        <translation>model pola</translation>
    </message>
    <message>
        <source>why amended</source>
        <translation>dlaczego poprawiono</translation>
    </message>
    <message>
        <source>revision</source>
        <translation>wydanie</translation>
    </message>
    <message>
        <source>nothing read</source>
        <translation>nic nie odczytano</translation>
    </message>
    <message>
        <source>%1 of a reading</source>
        <translation>%1 odczytu</translation>
    </message>
    <message>
        <source>%1 of the reading on %2°</source>
        <translation>%1 odczytu na %2°</translation>
    </message>
    <message>
        <source>as %1</source>
        <translation>jako %1</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s)</source>
        <translation>
            <numerusform>%n odczyt</numerusform>
            <numerusform>%n odczyty</numerusform>
            <numerusform>%n odczytów</numerusform>
        </translation>
    </message>
    <message>
        <source>errors that all readings share (°)</source>
        <translation>błędy wspólne wszystkim odczytom (°)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Badge</name>
    <message>
        <source>in limits</source>
        <translation>w granicach</translation>
    </message>
    <message>
        <source>out of limits</source>
        <translation>poza granicami</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nieznany</translation>
    </message>
    <message>
        <source>In limits: the newest swing of every compass keeps the limits set for it</source>
        <translation>W granicach: najnowszy pomiar każdej busoli mieści się w wartościach dopuszczalnych</translation>
    </message>
    <message>
        <source>Out of limits: the newest swing of a compass exceeds the limits set for it</source>
        <translation>Poza granicami: najnowszy pomiar którejś busoli przekracza wartości dopuszczalne</translation>
    </message>
    <message>
        <source>Not known: no limits are set, or no swing with a result is on record</source>
        <translation>Nieznany: nie ustalono wartości dopuszczalnych albo nie ma pomiaru z wynikiem</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::BenchDrawing</name>
    <message>
        <source>The bench from above and from the side</source>
        <translation>Stanowisko z góry i z boku</translation>
    </message>
    <message>
        <source>from above (nose left, starboard up)</source>
        <translation>z góry (nos w lewo, prawa burta w górę)</translation>
    </message>
    <message>
        <source>from the port side (nose left)</source>
        <translation>z lewej burty (nos w lewo)</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>czujnik</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1: %2 m forward, %3 m starboard, %4 m down</source>
        <translation>%1: %2 m w przód, %3 m w prawo, %4 m w dół</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::BenchResults</name>
    <message>
        <source>hard iron P %1, Q %2, R %3 nT
soft iron S:</source>
        <translation>żelazo twarde P %1, Q %2, R %3 nT
żelazo miękkie S:</translation>
    </message>
    <message>
        <source>
%1, %2 A, %3: S %4, T %5, V %6 nT</source>
        <translation>
%1, %2 A, %3: S %4, T %5, V %6 nT</translation>
    </message>
    <message>
        <source>on</source>
        <translation>włączone</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wyłączone</translation>
    </message>
    <message>
        <source>&amp;Parts&apos; shares</source>
        <translation>&amp;Udział części</translation>
    </message>
    <message>
        <source>&amp;Coefficients</source>
        <translation>&amp;Współczynniki</translation>
    </message>
    <message>
        <source>part</source>
        <translation>część</translation>
    </message>
    <message>
        <source>distance (m)</source>
        <translation>odległość (m)</translation>
    </message>
    <message>
        <source>by</source>
        <translation>przez</translation>
    </message>
    <message>
        <source>P (nT)</source>
        <translation>P (nT)</translation>
    </message>
    <message>
        <source>Q (nT)</source>
        <translation>Q (nT)</translation>
    </message>
    <message>
        <source>R (nT)</source>
        <translation>R (nT)</translation>
    </message>
    <message>
        <source>c</source>
        <translation>c</translation>
    </message>
    <message>
        <source>f</source>
        <translation>f</translation>
    </message>
    <message>
        <source>Each part&apos;s share</source>
        <translation>Udział każdej części</translation>
    </message>
    <message>
        <source>dipole</source>
        <translation>dipol</translation>
    </message>
    <message>
        <source>tensor</source>
        <translation>tensor</translation>
    </message>
    <message>
        <source>may drift (nT)</source>
        <translation>może się zmienić o (nT)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::BenchRows</name>
    <message>
        <source>row %1: %2</source>
        <translation>wiersz %1: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1” nie jest liczbą</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 numbers; expected %3 apart by spaces</source>
        <translation>„%1” ma liczb: %2; oczekiwano %3 oddzielonych odstępami</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no shape; expected box, cylinder, ellipsoid or sphere</source>
        <translation>„%1” nie jest kształtem; oczekiwano: box, cylinder, ellipsoid lub sphere</translation>
    </message>
    <message>
        <source>a loop has 8 numbers: centre x y z; normal x y z; diameter; turns</source>
        <translation>pętla ma 8 liczb: środek x y z; normalna x y z; średnica; zwoje</translation>
    </message>
    <message>
        <source>a loop has a whole number of turns, 1 or more</source>
        <translation>pętla ma całkowitą liczbę zwojów, co najmniej 1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no conductor; expected loop or wire</source>
        <translation>„%1” nie jest przewodem; oczekiwano: loop lub wire</translation>
    </message>
    <message>
        <source>a wire has points x y z; x y z; … two at least</source>
        <translation>przewód ma punkty x y z; x y z; … co najmniej dwa</translation>
    </message>
    <message>
        <source>the first row has no name</source>
        <translation>pierwszy wiersz nie ma nazwy</translation>
    </message>
    <message>
        <source>the first conductor has no circuit</source>
        <translation>pierwszy przewód nie ma obwodu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no state of a circuit; expected on or off</source>
        <translation>„%1” nie jest stanem obwodu; oczekiwano: on lub off</translation>
    </message>
    <message>
        <source>part</source>
        <translation>część</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>kształt</translation>
    </message>
    <message>
        <source>size (m)</source>
        <translation>wymiary (m)</translation>
    </message>
    <message>
        <source>χ</source>
        <translation>χ</translation>
    </message>
    <message>
        <source>remanence (T)</source>
        <translation>remanencja (T)</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupa</translation>
    </message>
    <message>
        <source>state</source>
        <translation>stan</translation>
    </message>
    <message>
        <source>centre x y z (m)</source>
        <translation>środek x y z (m)</translation>
    </message>
    <message>
        <source>roll pitch yaw (°)</source>
        <translation>przechylenie pochylenie odchylenie (°)</translation>
    </message>
    <message>
        <source>circuit</source>
        <translation>obwód</translation>
    </message>
    <message>
        <source>current (A)</source>
        <translation>prąd (A)</translation>
    </message>
    <message>
        <source>on/off</source>
        <translation>wł./wył.</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>rodzaj</translation>
    </message>
    <message>
        <source>geometry (m)</source>
        <translation>geometria (m)</translation>
    </message>
    <message>
        <source>sensor: %1</source>
        <translation>czujnik: %1</translation>
    </message>
    <message>
        <source>(circuits) %1</source>
        <translation>(obwody) %1</translation>
    </message>
    <message>
        <source>a coercivity is 0 A/m or more</source>
        <translation>koercja wynosi 0 A/m lub więcej</translation>
    </message>
    <message>
        <source>coercivity (A/m)</source>
        <translation>koercja (A/m)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::BenchTables</name>
    <message>
        <source>Ferrous parts</source>
        <translation>Części ferromagnetyczne</translation>
    </message>
    <message>
        <source>Loops and wires</source>
        <translation>Pętle i przewody</translation>
    </message>
    <message>
        <source>Sens&amp;or x y z (m, forward, starboard, down):</source>
        <translation>&amp;Czujnik x y z (m, w przód, w prawo, w dół):</translation>
    </message>
    <message>
        <source>Add part</source>
        <translation>Dodaj część</translation>
    </message>
    <message>
        <source>Add conductor</source>
        <translation>Dodaj przewód</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Powiel</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Usuń wiersz</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (kopia)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CalibrationPage</name>
    <message>
        <source>&apos;%1&apos; is not allowed for %2; expected %3 to %4</source>
        <translation>&apos;%1&apos; jest niedozwolone dla %2; oczekiwano od %3 do %4</translation>
    </message>
    <message>
        <source>empty: not known</source>
        <translation>puste: nieznane</translation>
    </message>
    <message>
        <source>empty: not known; down +</source>
        <translation>puste: nieznane; w dół +</translation>
    </message>
    <message>
        <source>standard deviation; empty: exact</source>
        <translation>odchylenie standardowe; puste: dokładne</translation>
    </message>
    <message>
        <source>Only the part of the log that is zoomed in</source>
        <translation>Tylko powiększona część zapisu</translation>
    </message>
    <message>
        <source>&amp;Open a log…</source>
        <translation>&amp;Otwórz zapis…</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>&amp;Kalibruj</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>&amp;Save the model…</source>
        <translation>Zapisz &amp;model…</translation>
    </message>
    <message>
        <source>Store with the c&amp;ompass</source>
        <translation>Zachowaj przy &amp;busoli</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Zapis</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Przed i po</translation>
    </message>
    <message>
        <source>Column x (forward):</source>
        <translation>Kolumna x (do przodu):</translation>
    </message>
    <message>
        <source>Column y (right):</source>
        <translation>Kolumna y (w prawo):</translation>
    </message>
    <message>
        <source>Column z (down):</source>
        <translation>Kolumna z (w dół):</translation>
    </message>
    <message>
        <source>Time:</source>
        <translation>Czas:</translation>
    </message>
    <message>
        <source>Magnetic heading:</source>
        <translation>Kurs magnetyczny:</translation>
    </message>
    <message>
        <source>Pitch (nose up +):</source>
        <translation>Pochylenie (nos w górę +):</translation>
    </message>
    <message>
        <source>Roll (right wing down +):</source>
        <translation>Przechylenie (prawe skrzydło w dół +):</translation>
    </message>
    <message>
        <source>as recognised</source>
        <translation>jak rozpoznano</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>zliczenia</translation>
    </message>
    <message>
        <source>ellipsoid (the field&apos;s size, 10 parameters)</source>
        <translation>elipsoida (wielkość pola, 10 parametrów)</translation>
    </message>
    <message>
        <source>axes (7 parameters)</source>
        <translation>osie (7 parametrów)</translation>
    </message>
    <message>
        <source>sphere (4 parameters)</source>
        <translation>kula (4 parametry)</translation>
    </message>
    <message>
        <source>against heading, pitch and roll</source>
        <translation>względem kursu, pochylenia i przechylenia</translation>
    </message>
    <message>
        <source>&amp;Unit:</source>
        <translation>&amp;Jednostka:</translation>
    </message>
    <message>
        <source>&amp;Method:</source>
        <translation>M&amp;etoda:</translation>
    </message>
    <message>
        <source>Earth&apos;s &amp;field (nT):</source>
        <translation>&amp;Pole Ziemi (nT):</translation>
    </message>
    <message>
        <source>Its &amp;dip (°):</source>
        <translation>&amp;Inklinacja (°):</translation>
    </message>
    <message>
        <source>&amp;Attitude sure to (°):</source>
        <translation>Położenie kątowe pe&amp;wne do (°):</translation>
    </message>
    <message>
        <source>A log of a magnetometer (CSV). Turn it slowly through all attitudes: each side up once, with a full turn in each.</source>
        <translation>Zapis magnetometru (CSV). Obracaj go powoli przez wszystkie położenia: każdym bokiem raz do góry, z pełnym obrotem w każdym.</translation>
    </message>
    <message>
        <source>Among the sensor models of the compass from whose page this one was opened: maps and predictions take it from there</source>
        <translation>Wśród modeli czujnika busoli, z której strony otwarto tę stronę: stąd biorą go mapy i przewidywania</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Kierunki</translation>
    </message>
    <message>
        <source>Calibration of a magnetometer from its log</source>
        <translation>Kalibracja magnetometru z jego zapisu</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>czas (s)</translation>
    </message>
    <message>
        <source>Open a log: it is drawn here. Drag to zoom.</source>
        <translation>Otwórz zapis: zostanie tu narysowany. Przeciągnij, aby powiększyć.</translation>
    </message>
    <message>
        <source>Nothing is calibrated yet.</source>
        <translation>Nic jeszcze nie skalibrowano.</translation>
    </message>
    <message>
        <source>Open a sensor log</source>
        <translation>Otwieranie zapisu czujnika</translation>
    </message>
    <message>
        <source>Sensor logs (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>Zapisy czujnika (*.csv *.txt *.tsv *.dat);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(brak)</translation>
    </message>
    <message>
        <source>the Earth&apos;s field</source>
        <translation>pole Ziemi</translation>
    </message>
    <message>
        <source>the dip</source>
        <translation>inklinacja</translation>
    </message>
    <message>
        <source>how sure the attitude is</source>
        <translation>pewność położenia kątowego</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Trwa obliczanie…</translation>
    </message>
    <message>
        <source>row</source>
        <translation>wiersz</translation>
    </message>
    <message>
        <source>field (%1)</source>
        <translation>pole (%1)</translation>
    </message>
    <message>
        <source>No calibration comes of this log: see why, and what to do next.</source>
        <translation>Z tego zapisu nie ma kalibracji: zobacz dlaczego i co zrobić dalej.</translation>
    </message>
    <message>
        <source>magnetic heading (°)</source>
        <translation>kurs magnetyczny (°)</translation>
    </message>
    <message>
        <source>heading error, read − magnetic (°)</source>
        <translation>błąd kursu, odczytany − magnetyczny (°)</translation>
    </message>
    <message>
        <source>before</source>
        <translation>przedtem</translation>
    </message>
    <message>
        <source>after</source>
        <translation>po</translation>
    </message>
    <message>
        <source>the field&apos;s size (%1)</source>
        <translation>wielkość pola (%1)</translation>
    </message>
    <message>
        <source>Save the sensor model</source>
        <translation>Zapisywanie modelu czujnika</translation>
    </message>
    <message>
        <source>Sensor model (*.json);;C header with a self-test (*.h)</source>
        <translation>Model czujnika (*.json);;Nagłówek C z samokontrolą (*.h)</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>kalibracja %1</translation>
    </message>
    <message>
        <source>&amp;Calibration from a log…</source>
        <translation>&amp;Kalibracja z zapisu…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>Nothing to write yet: open a log</source>
        <translation>Nie ma jeszcze czego zapisać: otwórz zapis</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisywanie sprawozdania</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Deviation map</source>
        <translation>Mapa dewiacji</translation>
    </message>
    <message>
        <source>Write the &amp;report as PDF…</source>
        <translation>Zapisz &amp;sprawozdanie jako PDF…</translation>
    </message>
    <message>
        <source>Open a log of a magnetometer that was turned through all attitudes: its hard and soft iron, how sure they are, why no surer and what to do for better. Zoom into the log to use a part of it; Directions shows where no sample is; Deviation map shows what compensation takes away at each heading and pitch; the model is saved as JSON or as a C header, or stored among the sensor models of the compass from whose page this one was opened.</source>
        <translation>Otwórz zapis magnetometru, który obracano przez wszystkie położenia: jego żelazo twarde i miękkie, jak pewne są, dlaczego nie pewniejsze i co zrobić, by było lepiej. Powiększ zapis, aby użyć jego części; Kierunki pokazują, gdzie brak próbek; Mapa dewiacji pokazuje, co kompensacja usuwa na każdym kursie i pochyleniu; model zapisuje się jako JSON lub nagłówek C albo wśród modeli czujnika busoli, z której strony otwarto tę stronę.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CardPanel</name>
    <message>
        <source>&amp;Write this card…</source>
        <translation>&amp;Zapisz tę tablicę…</translation>
    </message>
    <message>
        <source>every %1°</source>
        <translation>co %1°</translation>
    </message>
    <message>
        <source>magnetic heading: what to steer</source>
        <translation>kurs magnetyczny: co utrzymywać</translation>
    </message>
    <message>
        <source>compass heading: which magnetic</source>
        <translation>kurs kompasowy: jaki magnetyczny</translation>
    </message>
    <message>
        <source>exact fit</source>
        <translation>dopasowanie dokładne</translation>
    </message>
    <message>
        <source>nearest reading</source>
        <translation>najbliższy odczyt</translation>
    </message>
    <message>
        <source>Correction card</source>
        <translation>Tablica dewiacji</translation>
    </message>
    <message>
        <source>Taken out mechanically after the swing: the card is then no longer what was signed</source>
        <translation>Usunięte mechanicznie po pomiarze: tablica nie jest już wtedy tym, co podpisano</translation>
    </message>
    <message>
        <source>Rows:</source>
        <translation>Wiersze:</translation>
    </message>
    <message>
        <source>By:</source>
        <translation>Według:</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>Z:</translation>
    </message>
    <message>
        <source>Without:</source>
        <translation>Bez:</translation>
    </message>
    <message>
        <source>Between rows:</source>
        <translation>Między wierszami:</translation>
    </message>
    <message>
        <source>COMPASS</source>
        <translation>BUSOLA</translation>
    </message>
    <message>
        <source>MAGNETIC</source>
        <translation>MAGNETYCZNY</translation>
    </message>
    <message>
        <source>deviation (°)</source>
        <translation>dewiacja (°)</translation>
    </message>
    <message>
        <source>± 95 % (°)</source>
        <translation>± 95 % (°)</translation>
    </message>
    <message>
        <source>FOR</source>
        <translation>NA KURS</translation>
    </message>
    <message>
        <source>STEER</source>
        <translation>STERUJ</translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation>%1. %2.</translation>
    </message>
    <message>
        <source>* nobody read near this row, ! over the limit</source>
        <translation>* w pobliżu tego wiersza nikt nie odczytał, ! ponad granicą</translation>
    </message>
    <message>
        <source>STEER %1 between the rows</source>
        <translation>UTRZYMUJ %1 między wierszami</translation>
    </message>
    <message>
        <source>MAGNETIC %1 between the rows</source>
        <translation>MAGNETYCZNY %1 między wierszami</translation>
    </message>
    <message>
        <source>, %1 by the curve</source>
        <translation>, %1 z krzywej</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ChartPlot</name>
    <message>
        <source>Components</source>
        <translation>Składowe</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Krzywa</translation>
    </message>
    <message>
        <source>Polar</source>
        <translation>Biegunowy</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Widmo</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CheckPage</name>
    <message>
        <source>&amp;Store as a check swing</source>
        <translation>&amp;Zachowaj jako pomiar kontrolny</translation>
    </message>
    <message>
        <source>Two-minute check</source>
        <translation>Sprawdzenie w dwie minuty</translation>
    </message>
    <message>
        <source>Standard deviation of one deviation as it is read on the apron: datum and compass together</source>
        <translation>Odchylenie standardowe jednej dewiacji odczytanej na płycie: wzorzec i busola razem</translation>
    </message>
    <message>
        <source>&amp;Headings to read:</source>
        <translation>&amp;Kursy do odczytania:</translation>
    </message>
    <message>
        <source>The card &amp;holds within:</source>
        <translation>&amp;Tablica ważna w granicach:</translation>
    </message>
    <message>
        <source>&amp;Error of a reading:</source>
        <translation>&amp;Błąd odczytu:</translation>
    </message>
    <message>
        <source>turn to, by compass</source>
        <translation>ustaw według busoli</translation>
    </message>
    <message>
        <source>datum, magnetic (°)</source>
        <translation>wzorzec, magnetyczny (°)</translation>
    </message>
    <message>
        <source>compass reads (°)</source>
        <translation>busola wskazuje (°)</translation>
    </message>
    <message>
        <source>from its card (°)</source>
        <translation>według jej tablicy (°)</translation>
    </message>
    <message>
        <source>Two-minute check: %1 · %2</source>
        <translation>Sprawdzenie w dwie minuty: %1 · %2</translation>
    </message>
    <message>
        <source>No swing on record: the check cannot know this compass&apos;s card.</source>
        <translation>Brak pomiaru w zapisach: sprawdzenie nie zna tablicy tej busoli.</translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) on record, the last %1 years ago. It wanders in a year by %2; since then something may have happened to it with %3 %.</source>
        <translation>
            <numerusform>%n pomiar w zapisach, ostatni %1 lat temu. W ciągu roku wędruje o %2; od tego czasu coś mogło się z nią stać z prawdopodobieństwem %3 %.</numerusform>
            <numerusform>%n pomiary w zapisach, ostatni %1 lat temu. W ciągu roku wędruje o %2; od tego czasu coś mogło się z nią stać z prawdopodobieństwem %3 %.</numerusform>
            <numerusform>%n pomiarów w zapisach, ostatni %1 lat temu. W ciągu roku wędruje o %2; od tego czasu coś mogło się z nią stać z prawdopodobieństwem %3 %.</numerusform>
        </translation>
    </message>
    <message>
        <source>These headings leave %1° of what would matter unknown; as many evenly spaced ones %2°.</source>
        <translation>Te kursy pozostawiają nieznane %1° z tego, co ma znaczenie; tyle samo równo rozłożonych: %2°.</translation>
    </message>
    <message>
        <source>Turn to each heading, and type what datum and compass read there.</source>
        <translation>Ustaw kolejno każdy kurs i wpisz, co wskazują na nim wzorzec i busola.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Sprawozdanie</translation>
    </message>
    <message>
        <source>%1 check.pdf</source>
        <translation>%1 sprawdzenie.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Two-minute check of a compass</source>
        <translation>Sprawdzenie busoli w dwie minuty</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Odczyty</translation>
    </message>
    <message>
        <source>Turn to</source>
        <translation>Obróć na</translation>
    </message>
    <message>
        <source>by compass</source>
        <translation>według busoli</translation>
    </message>
    <message>
        <source>Datum</source>
        <translation>Wzorzec</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnetyczny</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Kompasowy</translation>
    </message>
    <message>
        <source>From card</source>
        <translation>Z tablicy</translation>
    </message>
    <message>
        <source>T&amp;wo-minute check of this compass</source>
        <translation>Sprawd&amp;zenie tej busoli w dwie minuty</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Turn to the headings that are named, which are those that tell most about this compass given how it changed so far, and type what datum and compass read: whether its card still holds, and how probably that verdict is wrong. Each coefficient is believed to wander, N(0, σ²t) with σ learnt from its swings, and to jump now and then; the readings are weighed by Bayes&apos; rule. Stored, it is a check swing with the verdict in its note, completed and signed as any other; it is no swing for the calendar.</source>
        <translation>Ustaw podane kursy, czyli te, które przy dotychczasowych zmianach mówią o tej busoli najwięcej, i wpisz, co wskazują wzorzec i busola: czy jej tablica jest nadal ważna i jak prawdopodobna jest pomyłka tej oceny. Przyjmuje się, że każdy współczynnik wędruje, N(0, σ²t) z σ poznanym z pomiarów, i niekiedy skacze; odczyty waży się regułą Bayesa. Zachowane jest pomiarem kontrolnym z oceną w uwadze, uzupełnianym i podpisywanym jak każdy inny; dla kalendarza nie jest pomiarem.</translation>
    </message>
    <message>
        <source>Write the &amp;report…</source>
        <translation>Zapisz &amp;sprawozdanie…</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>kurs</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CircuitForm</name>
    <message>
        <source>on</source>
        <translation>włączone</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Name of the circuit</source>
        <translation>Nazwa obwodu</translation>
    </message>
    <message>
        <source>Remove this circuit</source>
        <translation>Usuń ten obwód</translation>
    </message>
    <message>
        <source>%1 switched on</source>
        <translation>włączono %1</translation>
    </message>
    <message>
        <source>%1 switched off</source>
        <translation>wyłączono %1</translation>
    </message>
    <message>
        <source>a circuit must have a name, as “landing light”</source>
        <translation>obwód musi mieć nazwę, np. „reflektor do lądowania”</translation>
    </message>
    <message>
        <source>name of a circuit</source>
        <translation>nazwa obwodu</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Clipboard</name>
    <message>
        <source>row %1 of what is pasted has text behind a closing quote</source>
        <translation>wiersz %1 wklejanych danych ma tekst za cudzysłowem zamykającym</translation>
    </message>
    <message>
        <source>more than %1 rows are to be pasted; expected a table of readings</source>
        <translation>wklejanych wierszy jest więcej niż %1; oczekiwano tabeli odczytów</translation>
    </message>
    <message>
        <source>a quote that begins in row %1 of what is pasted is not closed</source>
        <translation>cudzysłów otwarty w wierszu %1 wklejanych danych nie jest zamknięty</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CoefficientsPanel</name>
    <message>
        <source>Coefficients</source>
        <translation>Współczynniki</translation>
    </message>
    <message>
        <source>Approx. (°)</source>
        <translation>Przybl. (°)</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Dokładne</translation>
    </message>
    <message>
        <source>Rule (°)</source>
        <translation>Reguła (°)</translation>
    </message>
    <message>
        <source>Least squares of δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′ on compass headings</source>
        <translation>Najmniejsze kwadraty δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′ na kursach kompasowych</translation>
    </message>
    <message>
        <source>Exact Smith coefficients, dimensionless, on magnetic headings</source>
        <translation>Dokładne współczynniki Smitha, bezwymiarowe, na kursach magnetycznych</translation>
    </message>
    <message>
        <source>The classical rule for 8 or 4 points</source>
        <translation>Klasyczna reguła dla 8 lub 4 punktów</translation>
    </message>
    <message>
        <source>%1-point (°)</source>
        <translation>%1-punktowa (°)</translation>
    </message>
    <message>
        <source>Four points cannot tell D</source>
        <translation>Cztery punkty nie określają D</translation>
    </message>
    <message>
        <source>The rule needs readings near N, E, S and W</source>
        <translation>Reguła wymaga odczytów w pobliżu N, E, S i W</translation>
    </message>
    <message>
        <source>These headings cannot tell it</source>
        <translation>Na tych kursach nie da się go określić</translation>
    </message>
    <message>
        <source>N = %1</source>
        <translation>N = %1</translation>
    </message>
    <message>
        <source>rms residual %1° (exact %2°)</source>
        <translation>średnia kwadratowa reszt %1° (dokładna %2°)</translation>
    </message>
    <message>
        <source>degrees of freedom %1</source>
        <translation>stopnie swobody %1</translation>
    </message>
    <message>
        <source>condition %1</source>
        <translation>uwarunkowanie %1</translation>
    </message>
    <message>
        <source>95 % ±</source>
        <translation>95 % ±</translation>
    </message>
    <message>
        <source>No interval: there are no more readings than coefficients</source>
        <translation>Brak przedziału: odczytów nie jest więcej niż współczynników</translation>
    </message>
    <message>
        <source>95 % interval (Student): %1 standard errors of %2</source>
        <translation>Przedział 95 % (Student): %1 błędów standardowych %2</translation>
    </message>
    <message>
        <source>Half of the 95 % interval</source>
        <translation>Połowa przedziału 95 %</translation>
    </message>
    <message>
        <source>A click or Enter on a number opens where it comes from</source>
        <translation>Kliknięcie lub Enter na liczbie otwiera jej pochodzenie</translation>
    </message>
    <message>
        <source>95 % interval: %1 standard errors of %2 by the scatter (Student), and 1.96 of %3 that all readings share</source>
        <translation>przedział 95 %: %1 błędu standardowego %2 z rozrzutu (Student) oraz 1,96 błędu %3 wspólnego dla wszystkich odczytów</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CoilPanel</name>
    <message>
        <source>Coil bench</source>
        <translation>Stanowisko z cewkami</translation>
    </message>
    <message>
        <source>Kept benches</source>
        <translation>Przechowywane pomiary</translation>
    </message>
    <message>
        <source>date of the bench: today</source>
        <translation>data pomiaru: dzisiaj</translation>
    </message>
    <message>
        <source>serial number of the sensor</source>
        <translation>numer seryjny czujnika</translation>
    </message>
    <message>
        <source>note: bench, coil, by whom</source>
        <translation>uwaga: stanowisko, cewka, kto</translation>
    </message>
    <message>
        <source>&amp;Keep with the compass</source>
        <translation>Za&amp;chowaj przy busoli</translation>
    </message>
    <message>
        <source>Remove the bench</source>
        <translation>Usuń pomiar</translation>
    </message>
    <message>
        <source>A coil bench needs the applied field beside the measured one: ax_nT, ay_nT, az_nT; temperature_c where it was read.</source>
        <translation>Stanowisko z cewkami wymaga pola przyłożonego obok zmierzonego: ax_nT, ay_nT, az_nT; temperature_c, jeśli ją odczytano.</translation>
    </message>
    <message>
        <source>“%1” is no day; expected YYYY-MM-DD</source>
        <translation>„%1” nie jest dniem; oczekiwano RRRR-MM-DD</translation>
    </message>
    <message>
        <source>coil bench of %1</source>
        <translation>pomiar na stanowisku z cewkami z %1</translation>
    </message>
    <message>
        <source>coil bench of %1 removed</source>
        <translation>usunięto pomiar na stanowisku z cewkami z %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ComparePage</name>
    <message>
        <source>first reads (°)</source>
        <translation>pierwsza wskazuje (°)</translation>
    </message>
    <message>
        <source>second reads (°)</source>
        <translation>druga wskazuje (°)</translation>
    </message>
    <message>
        <source>datum, magnetic (°), where there is one</source>
        <translation>wzorzec, magnetyczny (°), jeśli jest</translation>
    </message>
    <message>
        <source>Make a swing &amp;due</source>
        <translation>&amp;Wyznacz pomiar dewiacji</translation>
    </message>
    <message>
        <source>Two compasses compared</source>
        <translation>Porównanie dwóch busol</translation>
    </message>
    <message>
        <source>&amp;Read a file…</source>
        <translation>Wczytaj &amp;plik…</translation>
    </message>
    <message>
        <source>&amp;Second compass:</source>
        <translation>&amp;Druga busola:</translation>
    </message>
    <message>
        <source>Notes the finding among the events of the aircraft: the due list names it as a reason until a swing is signed</source>
        <translation>Zapisuje wynik wśród zdarzeń statku powietrznego: wykaz terminów podaje go jako powód, dopóki pomiar nie zostanie podpisany</translation>
    </message>
    <message>
        <source>one that is not on record</source>
        <translation>taka, której nie ma w zapisach</translation>
    </message>
    <message>
        <source>Two compasses: %1 · first is %2</source>
        <translation>Dwie busole: %1 · pierwsza to %2</translation>
    </message>
    <message>
        <source>Two compasses read together</source>
        <translation>Dwie busole odczytane razem</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tabele (*.csv *.txt);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Type what both compasses read on each heading, as on taxiing out; a runway&apos;s direction is a datum.</source>
        <translation>Wpisz, co obie busole wskazują na każdym kursie, np. podczas kołowania; kierunek pasa jest wzorcem.</translation>
    </message>
    <message>
        <source>Noted among the events of %1; the due list names it.</source>
        <translation>Zapisano wśród zdarzeń %1; wykaz terminów to podaje.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Sprawozdanie</translation>
    </message>
    <message>
        <source>%1 two compasses.pdf</source>
        <translation>%1 dwie busole.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Odczyty</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Pierwsza</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Druga</translation>
    </message>
    <message>
        <source>Datum</source>
        <translation>Wzorzec</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnetyczny</translation>
    </message>
    <message>
        <source>C&amp;ompare with another compass</source>
        <translation>P&amp;orównaj z inną busolą</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Type what two compasses of one aircraft read together, or read a log of both: which of them moved. Corrected by their cards they differ by −x·Δ1 + x·Δ2, so that only how each of them changes, or a reading beside a datum, tells them apart; what moved both alike is not in the difference at all, and it is said. Make a swing due notes the finding among the events of the aircraft: the due list names it until a swing is signed or somebody answers for not swinging.</source>
        <translation>Wpisz, co dwie busole jednego statku powietrznego wskazały razem, albo wczytaj zapis obu: która z nich się zmieniła. Po poprawieniu według tablic różnią się o −x·Δ1 + x·Δ2, więc rozróżnia je tylko to, jak każda się zmienia, albo odczyt przy wzorcu; tego, co zmieniło obie jednakowo, w różnicy nie ma wcale, i jest to powiedziane. „Wyznacz pomiar dewiacji” zapisuje wynik wśród zdarzeń statku powietrznego: wykaz terminów go podaje, dopóki pomiar nie zostanie podpisany albo ktoś nie odpowie za odstąpienie.</translation>
    </message>
    <message>
        <source>Write the &amp;report…</source>
        <translation>Zapisz &amp;sprawozdanie…</translation>
    </message>
    <message>
        <source>No heading was read by both compasses yet: there is nothing to report.</source>
        <translation>Żadnego kursu nie odczytano jeszcze z obu busol: nie ma o czym sporządzić raportu.</translation>
    </message>
    <message>
        <source>Headings corrected by their cards, first − second: %1 (standard errors; a deviation of the first that rose makes it fall). That a card does not hold: first %2 %, second %3 %.</source>
        <translation>Kursy poprawione według tablic, pierwszy − drugi: %1 (błędy standardowe; gdy dewiacja pierwszego wzrosła, różnica maleje). Że tablica nie obowiązuje: pierwszy %2 %, drugi %3 %.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ComponentsChart</name>
    <message>
        <source>sum</source>
        <translation>suma</translation>
    </message>
    <message>
        <source>compass heading (°)</source>
        <translation>kurs kompasowy (°)</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>odczyty</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CoverageSphere</name>
    <message>
        <source>Directions of the field that the log has seen</source>
        <translation>Kierunki pola, które widział zapis</translation>
    </message>
    <message>
        <source>Turn it with the mouse or the arrow keys.</source>
        <translation>Obracaj myszą lub strzałkami.</translation>
    </message>
    <message>
        <source>nose</source>
        <translation>nos</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>ogon</translation>
    </message>
    <message>
        <source>right</source>
        <translation>prawa</translation>
    </message>
    <message>
        <source>left</source>
        <translation>lewa</translation>
    </message>
    <message>
        <source>belly</source>
        <translation>spód</translation>
    </message>
    <message>
        <source>roof</source>
        <translation>grzbiet</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>pasuje</translation>
    </message>
    <message>
        <source>field too strong</source>
        <translation>pole za silne</translation>
    </message>
    <message>
        <source>too weak</source>
        <translation>za słabe</translation>
    </message>
    <message>
        <source>no samples in the ring</source>
        <translation>brak próbek w pierścieniu</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CrewDisplay</name>
    <message>
        <source>Crew display</source>
        <translation>Ekran dla załogi</translation>
    </message>
    <message>
        <source>Turn the compass in its mount until it reads</source>
        <translation>Obracaj busolę w obsadzie, aż wskaże</translation>
    </message>
    <message>
        <source>Turn the %1 until the compass reads</source>
        <translation>Obracaj (%1), aż busola wskaże</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>na kursie %1</translation>
    </message>
    <message>
        <source>Turn to</source>
        <translation>Obróć na</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::CurveChart</name>
    <message>
        <source>95 % band</source>
        <translation>pas 95 %</translation>
    </message>
    <message>
        <source>previous swing</source>
        <translation>poprzedni pomiar</translation>
    </message>
    <message>
        <source>approximate fit</source>
        <translation>dopasowanie przybliżone</translation>
    </message>
    <message>
        <source>exact fit</source>
        <translation>dopasowanie dokładne</translation>
    </message>
    <message>
        <source>residual (°)</source>
        <translation>reszta (°)</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>odczyty</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>dopuszczalne</translation>
    </message>
    <message>
        <source>δ (°, east +)</source>
        <translation>δ (°, wsch. +)</translation>
    </message>
    <message>
        <source>δ (°)</source>
        <translation>δ (°)</translation>
    </message>
    <message>
        <source>res. (°)</source>
        <translation>reszta (°)</translation>
    </message>
    <message>
        <source>res.</source>
        <translation>reszta</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DatumPage</name>
    <message>
        <source>“%1” is no size; expected a number from 0</source>
        <translation>„%1” nie jest wielkością; oczekiwano liczby od 0</translation>
    </message>
    <message>
        <source>Sun over the day</source>
        <translation>Słońce w ciągu dnia</translation>
    </message>
    <message>
        <source>&amp;Latitude:</source>
        <translation>&amp;Szerokość geogr.:</translation>
    </message>
    <message>
        <source>L&amp;ongitude:</source>
        <translation>&amp;Długość geogr.:</translation>
    </message>
    <message>
        <source>&amp;Time (UTC):</source>
        <translation>&amp;Czas (UTC):</translation>
    </message>
    <message>
        <source>&amp;Variation (°, E +):</source>
        <translation>&amp;Deklinacja (°, E +):</translation>
    </message>
    <message>
        <source>by the model</source>
        <translation>według modelu</translation>
    </message>
    <message>
        <source>&amp;Read is the bearing of:</source>
        <translation>&amp;Odczytano namiar:</translation>
    </message>
    <message>
        <source>the shadow (pin)</source>
        <translation>cienia (pręt)</translation>
    </message>
    <message>
        <source>the sun (astrocompass, sight)</source>
        <translation>słońca (astrokompas, celownik)</translation>
    </message>
    <message>
        <source>from the &amp;nose, clockwise (°):</source>
        <translation>od &amp;nosa, w prawo (°):</translation>
    </message>
    <message>
        <source>Error of the clock (s):</source>
        <translation>Błąd zegara (s):</translation>
    </message>
    <message>
        <source>of the position (km):</source>
        <translation>położenia (km):</translation>
    </message>
    <message>
        <source>of pin or level (°):</source>
        <translation>pręta lub poziomu (°):</translation>
    </message>
    <message>
        <source>of pointing (°):</source>
        <translation>celowania (°):</translation>
    </message>
    <message>
        <source>of the variation (°):</source>
        <translation>deklinacji (°):</translation>
    </message>
    <message>
        <source>True &amp;heading (°):</source>
        <translation>&amp;Kurs rzeczywisty (°):</translation>
    </message>
    <message>
        <source>&amp;Meridian of grid north:</source>
        <translation>Po&amp;łudnik północy siatki:</translation>
    </message>
    <message>
        <source>Steps of a variation &amp;table (°):</source>
        <translation>Kroki tabeli deklinac&amp;ji (°):</translation>
    </message>
    <message>
        <source>“%1” are no steps of a table; expected 0.1 to 30 degrees</source>
        <translation>„%1” to nie krok tabeli; oczekiwano od 0.1 do 30 stopni</translation>
    </message>
    <message>
        <source>A datum anywhere</source>
        <translation>Wzorzec w dowolnym miejscu</translation>
    </message>
    <message>
        <source>Way to a heading</source>
        <translation>Droga do kursu</translation>
    </message>
    <message>
        <source>The sun (shadow pin, astrocompass)</source>
        <translation>Słońce (pręt cieniowy, astrokompas)</translation>
    </message>
    <message>
        <source>Lined up on a runway</source>
        <translation>Ustawienie na pasie</translation>
    </message>
    <message>
        <source>Transfer gyro</source>
        <translation>Żyroskop przenośny</translation>
    </message>
    <message>
        <source>By synchro</source>
        <translation>Przez selsyn</translation>
    </message>
    <message>
        <source>Grid heading near a pole</source>
        <translation>Kurs siatki w pobliżu bieguna</translation>
    </message>
    <message>
        <source>&amp;Direction, magnetic (°):</source>
        <translation>K&amp;ierunek, magnetyczny (°):</translation>
    </message>
    <message>
        <source>Error of its published direction (°):</source>
        <translation>Błąd ogłoszonego kierunku (°):</translation>
    </message>
    <message>
        <source>Nose and tail off the line by (m):</source>
        <translation>Nos i ogon obok linii o (m):</translation>
    </message>
    <message>
        <source>Between both points (m):</source>
        <translation>Między oboma punktami (m):</translation>
    </message>
    <message>
        <source>Error of &amp;setting it (°):</source>
        <translation>Błąd na&amp;stawienia (°):</translation>
    </message>
    <message>
        <source>of &amp;reading it (°):</source>
        <translation>odczytu (°):</translation>
    </message>
    <message>
        <source>Free &amp;drift (°/h):</source>
        <translation>Dryf swobodny (°/h):</translation>
    </message>
    <message>
        <source>&amp;Minutes since it was set:</source>
        <translation>&amp;Minuty od nastawienia:</translation>
    </message>
    <message>
        <source>&amp;One-cycle error, amplitude (°):</source>
        <translation>Błąd półokrężny, amplituda (°):</translation>
    </message>
    <message>
        <source>&amp;Two-cycle error, amplitude (°):</source>
        <translation>Błąd ćwierćokrężny, amplituda (°):</translation>
    </message>
    <message>
        <source>Parts of the error</source>
        <translation>Części błędu</translation>
    </message>
    <message>
        <source>Part of the error</source>
        <translation>Część błędu</translation>
    </message>
    <message>
        <source>one standard deviation (°)</source>
        <translation>jedno odchylenie standardowe (°)</translation>
    </message>
    <message>
        <source>Time of no&amp;w</source>
        <translation>&amp;Teraz</translation>
    </message>
    <message>
        <source>in all</source>
        <translation>razem</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Sprawozdanie</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>A datum away from a base</source>
        <translation>Wzorzec z dala od bazy</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>one standard deviation</source>
        <translation>jedno odchylenie standardowe</translation>
    </message>
    <message>
        <source>A d&amp;atum anywhere: sun, runway, gyro</source>
        <translation>W&amp;zorzec w dowolnym miejscu: słońce, pas, żyroskop</translation>
    </message>
    <message>
        <source>Ctrl+Alt+D</source>
        <translation>Ctrl+Alt+D</translation>
    </message>
    <message>
        <source>What tells a heading away from any base, and how well. Sun: heading = azimuth of the sun − its bearing from the nose (a shadow: less 180°); parts of its error: clock × rate of the azimuth, position, plumb × tan(elevation), pointing, variation (Meeus, Astronomical Formulae for Calculators, chapters 7, 8, 18; held against almanacs from 1950 to 2050). Runway: its published direction and √2 × off-centre ÷ distance of the points. Transfer gyro: setting, reading, drift × time. Synchro: one- and two-cycle errors of about 0.2° each (Kayton and Fried 9.2, 9.4). Grid: true − (λ − λ0) in the north, + in the south.</source>
        <translation>Co podaje kurs z dala od wszelkiej bazy i jak dobrze. Słońce: kurs = azymut słońca − jego namiar od nosa (cień: jeszcze −180°); części błędu: zegar × prędkość azymutu, położenie, pion × tan(wysokości), celowanie, deklinacja (Meeus, Astronomical Formulae for Calculators, rozdziały 7, 8, 18; sprawdzone z almanachami od 1950 do 2050). Pas: jego ogłoszony kierunek i √2 × odchyłka od osi ÷ odległość punktów. Żyroskop przenośny: nastawienie, odczyt, dryf × czas. Selsyn: błędy półokrężny i ćwierćokrężny po około 0.2° (Kayton i Fried 9.2, 9.4). Siatka: rzeczywisty − (λ − λ0) na północy, + na południu.</translation>
    </message>
    <message>
        <source>Write the &amp;report…</source>
        <translation>Zapisz &amp;sprawozdanie…</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DatumWords</name>
    <message>
        <source>Sun: azimuth %1 true, elevation %2°; it turns by %3° a minute.</source>
        <translation>Słońce: azymut rzeczywisty %1, wysokość %2°; obraca się o %3° na minutę.</translation>
    </message>
    <message>
        <source>Astrocompass: set latitude %1°, declination %2°, local hour angle %3.</source>
        <translation>Astrokompas: nastaw szerokość %1°, deklinację słońca %2°, miejscowy kąt godzinny %3.</translation>
    </message>
    <message>
        <source>The sun has set: no heading.</source>
        <translation>Słońce zaszło: brak kursu.</translation>
    </message>
    <message>
        <source>The shadow points to %1 true and is %2 times as long as its pin.</source>
        <translation>Cień wskazuje %1 rzeczywiście i jest %2 razy dłuższy od pręta.</translation>
    </message>
    <message>
        <source>A clock an hour fast (daylight saving) would turn every heading by %1°.</source>
        <translation>Zegar spieszący godzinę (czas letni) obróciłby każdy kurs o %1°.</translation>
    </message>
    <message>
        <source>Read the bearing of %1 from the nose.</source>
        <translation>Odczytaj namiar %1 od nosa.</translation>
    </message>
    <message>
        <source>the shadow</source>
        <translation>cienia</translation>
    </message>
    <message>
        <source>the sun</source>
        <translation>słońca</translation>
    </message>
    <message>
        <source>The aircraft heads %1 magnetic ± %2° (one standard deviation; %3 true, variation %4°).</source>
        <translation>Statek powietrzny ma kurs magnetyczny %1 ± %2° (odchylenie standardowe; rzeczywisty %3, deklinacja %4°).</translation>
    </message>
    <message>
        <source>Grid heading %1 (%2 true)</source>
        <translation>Kurs siatki %1 (rzeczywisty %2)</translation>
    </message>
    <message>
        <source>Convergence (true − grid) %1°; grid variation %2°, variation %3°.</source>
        <translation>Zbieżność (rzeczywisty − siatki) %1°; deklinacja siatki %2°, deklinacja %3°.</translation>
    </message>
    <message>
        <source>A table of variation in steps of %1°, read between its entries: %2°, wrong by %3° here and up to %4° in this cell.</source>
        <translation>Tabela deklinacji w krokach %1°, czytana między wpisami: %2°, błędna tu o %3°, a w tym polu do %4°.</translation>
    </message>
    <message>
        <source>The same by the nearest entry (steps of %1°): %2°, wrong by %3° here and up to %4° in this cell.</source>
        <translation>To samo według najbliższego wpisu (kroki %1°): %2°, błędne tu o %3°, a w tym polu do %4°.</translation>
    </message>
    <message>
        <source>%1 ± %2° (one standard deviation)</source>
        <translation>%1 ± %2° (jedno odchylenie standardowe)</translation>
    </message>
    <message>
        <source>hour of the day (UTC)</source>
        <translation>godzina dnia (UTC)</translation>
    </message>
    <message>
        <source>error of the heading (°, one standard deviation)</source>
        <translation>błąd kursu (°, jedno odchylenie standardowe)</translation>
    </message>
    <message>
        <source>Lined up, the aircraft heads %1 magnetic</source>
        <translation>Po ustawieniu w osi kurs magnetyczny wynosi %1</translation>
    </message>
    <message>
        <source>Lined up, the aircraft heads as the runway</source>
        <translation>Po ustawieniu w osi kurs jest kierunkiem pasa</translation>
    </message>
    <message>
        <source>The heading that the gyro carries</source>
        <translation>Kurs, który przenosi żyroskop</translation>
    </message>
    <message>
        <source>The heading that comes by synchro</source>
        <translation>Kurs przekazany selsynem</translation>
    </message>
    <message>
        <source>%1 UTC: elevation %2°, error %3°</source>
        <translation>%1 UTC: wysokość %2°, błąd %3°</translation>
    </message>
    <message>
        <source>%1 UTC: the sun has set</source>
        <translation>%1 UTC: słońce zaszło</translation>
    </message>
    <message>
        <source>error of a heading by the sun</source>
        <translation>błąd kursu według słońca</translation>
    </message>
    <message>
        <source>elevation of the sun (full height: 90°)</source>
        <translation>wysokość słońca (pełna skala: 90°)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DerivationPanel</name>
    <message>
        <source>magnetic ψ</source>
        <translation>magnetyczny ψ</translation>
    </message>
    <message>
        <source>compass ψ′</source>
        <translation>kompasowy ψ′</translation>
    </message>
    <message>
        <source>weight w</source>
        <translation>waga w</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>suma</translation>
    </message>
    <message>
        <source>No interval: there are no more readings than coefficients.</source>
        <translation>Brak przedziału: odczytów nie jest więcej niż współczynników.</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>przybliżone</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>dokładne</translation>
    </message>
    <message>
        <source>point rule</source>
        <translation>reguła punktowa</translation>
    </message>
    <message>
        <source>%1 (%2): these headings cannot tell it.</source>
        <translation>%1 (%2): te kursy go nie określają.</translation>
    </message>
    <message>
        <source>Solved for %1 that is a sum over the readings, Σ w·y: what each of them adds.</source>
        <translation>Po rozwiązaniu względem %1 jest to suma po odczytach, Σ w·y: ile wnosi każdy z nich.</translation>
    </message>
    <message>
        <source>Where the number comes from</source>
        <translation>Skąd pochodzi liczba</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Zamknij (Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>the standard error follows from the scatter of the readings, s = √(Σ residual² / %1) = %2°.</source>
        <translation>błąd standardowy wynika z rozrzutu odczytów, s = √(Σ reszta² / %1) = %2°.</translation>
    </message>
    <message>
        <source>95 % ± %1 = %2 × %3: Student&apos;s factor for %4 degrees of freedom times the standard error; </source>
        <translation>95 % ± %1 = %2 × %3: współczynnik Studenta dla %4 stopni swobody razy błąd standardowy; </translation>
    </message>
    <message>
        <source>95 % ± %1 = √((%2 × %3)² + (1.96 × %4)²): Student&apos;s factor for %5 degrees of freedom times the standard error by the scatter, and 1.96 of the error that all readings share, which is stated; </source>
        <translation>95 % ± %1 = √((%2 × %3)² + (1,96 × %4)²): współczynnik Studenta dla %5 stopni swobody razy błąd standardowy z rozrzutu oraz 1,96 podanego błędu wspólnego dla wszystkich odczytów; </translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Dialogs</name>
    <message>
        <source>Setting the pages…</source>
        <translation>Składanie stron…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DistributionDrawing</name>
    <message>
        <source>No swing tells %1.</source>
        <translation>Żaden pomiar nie określa %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n vote(s)</source>
        <translation>
            <numerusform>%1, %n głos</numerusform>
            <numerusform>%1, %n głosy</numerusform>
            <numerusform>%1, %n głosów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %n more far off</source>
        <translation>
            <numerusform>; dalej jeszcze %n</numerusform>
            <numerusform>; dalej jeszcze %n</numerusform>
            <numerusform>; dalej jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>next date</source>
        <translation>następny termin</translation>
    </message>
    <message>
        <source>Share of futures beyond the limit by then</source>
        <translation>Udział przebiegów przyszłości, które do tego czasu przekroczą granicę</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Documents</name>
    <message>
        <source>a card has %1 STEER columns here; expected one or two</source>
        <translation>tablica ma tu %1 kolumn STERUJ; oczekiwano jednej lub dwóch</translation>
    </message>
    <message>
        <source>; %1 taken out mechanically after the swing and not in these figures</source>
        <translation>; %1 usunięto mechanicznie po pomiarze, nie ma go w tych liczbach</translation>
    </message>
    <message>
        <source>deviation by the exact fit at each heading</source>
        <translation>dewiacja z dokładnego dopasowania na każdym kursie</translation>
    </message>
    <message>
        <source>deviation of the reading nearest to each heading</source>
        <translation>dewiacja odczytu najbliższego każdemu kursowi</translation>
    </message>
    <message>
        <source>STEER = FOR − deviation, to whole degrees; %1%2</source>
        <translation>STERUJ = NA KURS − dewiacja, do pełnych stopni; %1%2</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>adjustment: the figures are what remains</source>
        <translation>kompensacji: liczby są tym, co pozostało</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Odbiorniki</translation>
    </message>
    <message>
        <source>push the deviation past 10° while they are on: %1</source>
        <translation>po włączeniu zwiększają dewiację ponad 10°: %1</translation>
    </message>
    <message>
        <source>Next swing</source>
        <translation>Następny pomiar</translation>
    </message>
    <message>
        <source>due on %1 by the calendar; earlier after an event that makes one due</source>
        <translation>według kalendarza %1; wcześniej po zdarzeniu, które go wymaga</translation>
    </message>
    <message>
        <source>Reprint</source>
        <translation>Ponowny wydruk</translation>
    </message>
    <message>
        <source>of the card of %1, from the record</source>
        <translation>tablicy z %1, z zapisu</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Użycie</translation>
    </message>
    <message>
        <source>FOR</source>
        <translation>NA KURS</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnetyczny</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Dewiacja</translation>
    </message>
    <message>
        <source>corrected for</source>
        <translation>poprawione dla</translation>
    </message>
    <message>
        <source>50 mm when printed at 100 %</source>
        <translation>50 mm przy wydruku w skali 100 %</translation>
    </message>
    <message>
        <source>Compass correction card</source>
        <translation>Tablica dewiacji busoli</translation>
    </message>
    <message>
        <source>S/N</source>
        <translation>Nr ser.</translation>
    </message>
    <message>
        <source>CONFIGURATION NOT STATED</source>
        <translation>NIE PODANO KONFIGURACJI</translation>
    </message>
    <message>
        <source>OVER 10° WITH</source>
        <translation>PONAD 10° PRZY</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>Podpisano</translation>
    </message>
    <message>
        <source>Swung at %1</source>
        <translation>Pomiar: %1</translation>
    </message>
    <message>
        <source>a site not stated</source>
        <translation>miejsce niepodane</translation>
    </message>
    <message>
        <source> rev. %1</source>
        <translation> wyd. %1</translation>
    </message>
    <message>
        <source>Reprint of %1</source>
        <translation>Ponowny wydruk z %1</translation>
    </message>
    <message>
        <source>Steer this by compass to make good FOR (magnetic).</source>
        <translation>Steruj tym kursem kompasowym, aby utrzymać NA KURS (magnetyczny).</translation>
    </message>
    <message>
        <source>Deviation = magnetic − compass, E +</source>
        <translation>Dewiacja = kurs magnetyczny − kompasowy, E +</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>stan zastany</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>kompensacja</translation>
    </message>
    <message>
        <source>check</source>
        <translation>kontrola</translation>
    </message>
    <message>
        <source>take out all: make compass read = compass + d</source>
        <translation>usuń całość: ustaw wskazanie busoli = busola + d</translation>
    </message>
    <message>
        <source>take out half: make compass read = compass + d/2</source>
        <translation>usuń połowę: ustaw wskazanie busoli = busola + d/2</translation>
    </message>
    <message>
        <source>A = (dN + dE + dS + dW)/4 = ____ ; make compass read = compass + A = ____</source>
        <translation>A = (dN + dE + dS + dW)/4 = ____ ; ustaw wskazanie busoli = busola + A = ____</translation>
    </message>
    <message>
        <source>C = (dN − dS)/2 = ____ ; N–S screw: make compass read = compass %1 C = ____</source>
        <translation>C = (dN − dS)/2 = ____ ; śruba N–S: ustaw wskazanie busoli = busola %1 C = ____</translation>
    </message>
    <message>
        <source>B = (dE − dW)/2 = ____ ; E–W screw: make compass read = compass %1 B = ____</source>
        <translation>B = (dE − dW)/2 = ____ ; śruba E–W: ustaw wskazanie busoli = busola %1 B = ____</translation>
    </message>
    <message>
        <source>Signs</source>
        <translation>Znaki</translation>
    </message>
    <message>
        <source>d = magnetic − compass, easterly positive. Datum: %1</source>
        <translation>d = kurs magnetyczny − kompasowy, wschodnia dodatnia. Wzorzec: %1</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Osoby</translation>
    </message>
    <message>
        <source>%1 ; it read after: ____</source>
        <translation>%1 ; potem wskazała: ____</translation>
    </message>
    <message>
        <source>To be filled in</source>
        <translation>Do wypełnienia</translation>
    </message>
    <message>
        <source>what</source>
        <translation>co</translation>
    </message>
    <message>
        <source>Before the first reading</source>
        <translation>Przed pierwszym odczytem</translation>
    </message>
    <message>
        <source>done</source>
        <translation>wykonano</translation>
    </message>
    <message>
        <source>Interference: compass with engines and electrics off and on</source>
        <translation>Zakłócenia: busola przy wyłączonych i włączonych silnikach i odbiornikach</translation>
    </message>
    <message>
        <source>heading °</source>
        <translation>kurs °</translation>
    </message>
    <message>
        <source>load</source>
        <translation>odbiornik</translation>
    </message>
    <message>
        <source>off °</source>
        <translation>wył. °</translation>
    </message>
    <message>
        <source>on °</source>
        <translation>wł. °</translation>
    </message>
    <message>
        <source>change °</source>
        <translation>zmiana °</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Stanowiska</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>nr</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>faza</translation>
    </message>
    <message>
        <source>to °</source>
        <translation>na °</translation>
    </message>
    <message>
        <source>datum 1</source>
        <translation>wzorzec 1</translation>
    </message>
    <message>
        <source>2</source>
        <translation>2</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>comp. 1</source>
        <translation>bus. 1</translation>
    </message>
    <message>
        <source>d °</source>
        <translation>d °</translation>
    </message>
    <message>
        <source>do here, and what it read after</source>
        <translation>czynność tutaj i wskazanie po niej</translation>
    </message>
    <message>
        <source>After the check swing</source>
        <translation>Po pomiarze kontrolnym</translation>
    </message>
    <message>
        <source>index</source>
        <translation>nastawienie</translation>
    </message>
    <message>
        <source>A = (dN + dE + dS + dW)/4 of the check swing = ____ ; turn the compass in its mount until it reads compass + A = ____ ; it read ____</source>
        <translation>A = (dN + dE + dS + dW)/4 z pomiaru kontrolnego = ____ ; obróć busolę w obsadzie, aż wskaże busola + A = ____ ; wskazała ____</translation>
    </message>
    <message>
        <source>datum read by</source>
        <translation>wzorzec odczytał</translation>
    </message>
    <message>
        <source>compass read by</source>
        <translation>busolę odczytał</translation>
    </message>
    <message>
        <source>date and times (UTC)</source>
        <translation>data i czas (UTC)</translation>
    </message>
    <message>
        <source>Compass swing: job card</source>
        <translation>Pomiar dewiacji busoli: karta pracy</translation>
    </message>
    <message>
        <source>TO FLY (M)</source>
        <translation>LEĆ (M)</translation>
    </message>
    <message>
        <source>STEER (C)</source>
        <translation>STERUJ (K)</translation>
    </message>
    <message>
        <source>cut here: the lower part stays with the compass, the upper part goes to the logbook</source>
        <translation>tu ciąć: dolna część pozostaje przy busoli, górna trafia do książki</translation>
    </message>
    <message>
        <source>Pilot&apos;s compass correction card (DD 1613 style)</source>
        <translation>Tablica dewiacji dla pilota (w układzie DD 1613)</translation>
    </message>
    <message>
        <source>On this sheet DEV = compass heading − magnetic heading; positive where the compass reads more.</source>
        <translation>Na tym arkuszu DEV = kurs kompasowy − kurs magnetyczny; dodatnia, gdy busola wskazuje więcej.</translation>
    </message>
    <message>
        <source>Compensating swing, residual swing, computation</source>
        <translation>Pomiar kompensacyjny, pomiar resztkowy, obliczenie</translation>
    </message>
    <message>
        <source>Rose</source>
        <translation>Krąg</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>kurs</translation>
    </message>
    <message>
        <source>Compensating</source>
        <translation>Pomiar kom-</translation>
    </message>
    <message>
        <source>(1) actual M</source>
        <translation>(1) rzecz. M</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>pensacyjny</translation>
    </message>
    <message>
        <source>(2) comp C</source>
        <translation>(2) bus. K</translation>
    </message>
    <message>
        <source>DEV</source>
        <translation>DEW</translation>
    </message>
    <message>
        <source>(2) − (1)</source>
        <translation>(2) − (1)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Reszta</translation>
    </message>
    <message>
        <source>(3) actual M</source>
        <translation>(3) rzecz. M</translation>
    </message>
    <message>
        <source>(4) comp C</source>
        <translation>(4) bus. K</translation>
    </message>
    <message>
        <source>C to M</source>
        <translation>K na M</translation>
    </message>
    <message>
        <source>(3) − (4)</source>
        <translation>(3) − (4)</translation>
    </message>
    <message>
        <source>M to C</source>
        <translation>M na K</translation>
    </message>
    <message>
        <source>(4) − (3)</source>
        <translation>(4) − (3)</translation>
    </message>
    <message>
        <source>no font is installed, and a document without one would be blank; install the package fonts-dejavu-core</source>
        <translation>nie zainstalowano czcionki, a bez niej dokument byłby pusty; zainstaluj pakiet fonts-dejavu-core</translation>
    </message>
    <message>
        <source>the printer takes no pages; expected one that is switched on and connected</source>
        <translation>drukarka nie przyjmuje stron; oczekiwano włączonej i podłączonej</translation>
    </message>
    <message>
        <source>the printer stopped before page %1 of %2</source>
        <translation>drukarka zatrzymała się przed stroną %1 z %2</translation>
    </message>
    <message>
        <source>made by %1</source>
        <translation>wykonano w %1</translation>
    </message>
    <message>
        <source>made %1 by %2</source>
        <translation>wykonano %1 w %2</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>strona %1 z %2</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>Zapis %1</translation>
    </message>
    <message>
        <source>Data SHA-256 %1</source>
        <translation>SHA-256 danych %1</translation>
    </message>
    <message>
        <source>Deviation = magnetic heading − compass heading; easterly is positive.</source>
        <translation>Dewiacja = kurs magnetyczny − kurs kompasowy; wschodnia dodatnia.</translation>
    </message>
    <message>
        <source>a QR code cannot hold &apos;%1&apos;; expected some text, up to about 2,000 characters</source>
        <translation>kod QR nie pomieści „%1”; oczekiwano tekstu do około 2000 znaków</translation>
    </message>
    <message>
        <source>this document cannot be written under this name; expected one that ends in .pdf</source>
        <translation>tego dokumentu nie da się zapisać pod tą nazwą; oczekiwano kończącej się na .pdf</translation>
    </message>
    <message>
        <source>DEMONSTRATION DATA</source>
        <translation>DANE POKAZOWE</translation>
    </message>
    <message>
        <source>DRAFT — NOT SIGNED</source>
        <translation>SZKIC — NIEPODPISANY</translation>
    </message>
    <message>
        <source>radio</source>
        <translation>radio</translation>
    </message>
    <message>
        <source>engines</source>
        <translation>silniki</translation>
    </message>
    <message>
        <source>electrics</source>
        <translation>odbiorniki elektryczne</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>Deviation over heading and roll, modelled</source>
        <translation>Dewiacja w funkcji kursu i przechylenia, modelowana</translation>
    </message>
    <message>
        <source>Earth&apos;s field and sensor model</source>
        <translation>Pole Ziemi i model czujnika</translation>
    </message>
    <message>
        <source>What it cannot tell</source>
        <translation>Czego nie określa</translation>
    </message>
    <message>
        <source>Sensor model of the compass</source>
        <translation>Model czujnika busoli</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>%1 m above the ellipsoid</source>
        <translation>%1 m nad elipsoidą</translation>
    </message>
    <message>
        <source>%1° (east +)</source>
        <translation>%1° (wschodnia +)</translation>
    </message>
    <message>
        <source>the swing states %1°</source>
        <translation>w pomiarze podano %1°</translation>
    </message>
    <message>
        <source>they differ by more than %1°: to be looked at</source>
        <translation>różnią się o więcej niż %1°: do sprawdzenia</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <translation>%1 dla %2</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Położenie</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>north %1, east %2, down %3 nT; horizontal H %4 nT, total F %5 nT</source>
        <translation>północ %1, wschód %2, w dół %3 nT; poziome H %4 nT, całkowite F %5 nT</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Inklinacja</translation>
    </message>
    <message>
        <source>%1° (down +)</source>
        <translation>%1° (w dół +)</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Deklinacja</translation>
    </message>
    <message>
        <source>What this swing tells of the iron: exact coefficients as Poisson&apos;s combinations</source>
        <translation>Co ten pomiar mówi o żelazie: dokładne współczynniki jako kombinacje Poissona</translation>
    </message>
    <message>
        <source>Coefficient</source>
        <translation>Współczynnik</translation>
    </message>
    <message>
        <source>Combination</source>
        <translation>Kombinacja</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Wyznaczono</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>bez jednostki</translation>
    </message>
    <message>
        <source>± std. error</source>
        <translation>± błąd std.</translation>
    </message>
    <message>
        <source>the headings of this swing do not tell all five coefficients, so nothing is said of Poisson&apos;s parameters</source>
        <translation>kursy tego pomiaru nie określają wszystkich pięciu współczynników, więc o parametrach Poissona nic nie wiadomo</translation>
    </message>
    <message>
        <source>N–S (C)</source>
        <translation>N–S (C)</translation>
    </message>
    <message>
        <source>E–W (B)</source>
        <translation>E–W (B)</translation>
    </message>
    <message>
        <source>index (A)</source>
        <translation>nastawienie (A)</translation>
    </message>
    <message>
        <source>As found, before a control was turned on it, and what was left there</source>
        <translation>Stan zastany, przed obrotem regulacji, i co tam pozostało</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominalny</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>dewiacja</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>stan końcowy</translation>
    </message>
    <message>
        <source>note</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <source>Adjustments: what the compass read, was to read, and read after</source>
        <translation>Regulacje: co busola wskazywała, co miała wskazać i co wskazała potem</translation>
    </message>
    <message>
        <source>time (UTC)</source>
        <translation>czas (UTC)</translation>
    </message>
    <message>
        <source>on</source>
        <translation>włączone</translation>
    </message>
    <message>
        <source>control</source>
        <translation>regulacja</translation>
    </message>
    <message>
        <source>read</source>
        <translation>wskazanie</translation>
    </message>
    <message>
        <source>to read</source>
        <translation>wymagane</translation>
    </message>
    <message>
        <source>after</source>
        <translation>po</translation>
    </message>
    <message>
        <source>left as it is: %1</source>
        <translation>pozostawiono: %1</translation>
    </message>
    <message>
        <source>after the check swing</source>
        <translation>po pomiarze kontrolnym</translation>
    </message>
    <message>
        <source>left in: %1</source>
        <translation>pozostawiono: %1</translation>
    </message>
    <message>
        <source>done (UTC)</source>
        <translation>wykonano (UTC)</translation>
    </message>
    <message>
        <source>Interference: the compass with a load off and on</source>
        <translation>Zakłócenia: busola przy wyłączonym i włączonym odbiorniku</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wyłączone</translation>
    </message>
    <message>
        <source>change</source>
        <translation>zmiana</translation>
    </message>
    <message>
        <source>Put aside, skipped, faults and review</source>
        <translation>Odrzucone, pominięte, usterki i przegląd</translation>
    </message>
    <message>
        <source>why</source>
        <translation>dlaczego</translation>
    </message>
    <message>
        <source>put aside</source>
        <translation>odrzucono</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>pominięto</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>usterka</translation>
    </message>
    <message>
        <source>mended</source>
        <translation>usunięto</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>przyjęto</translation>
    </message>
    <message>
        <source>Figures as they were read</source>
        <translation>Wartości, jak odczytano</translation>
    </message>
    <message>
        <source>datum (°)</source>
        <translation>wzorzec (°)</translation>
    </message>
    <message>
        <source>datum from astern (°)</source>
        <translation>wzorzec od tyłu (°)</translation>
    </message>
    <message>
        <source>compass (°)</source>
        <translation>busola (°)</translation>
    </message>
    <message>
        <source>What this revision changes: %1</source>
        <translation>Co zmienia to wydanie: %1</translation>
    </message>
    <message>
        <source>before</source>
        <translation>przedtem</translation>
    </message>
    <message>
        <source>now</source>
        <translation>teraz</translation>
    </message>
    <message>
        <source>a report cannot be written under this name; expected one that ends in .pdf, .html, .csv or .json</source>
        <translation>sprawozdania nie da się zapisać pod tą nazwą; oczekiwano kończącej się na .pdf, .html, .csv lub .json</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>to folder</translation>
    </message>
    <message>
        <source>cannot be read: %1; expected a report PDF</source>
        <translation>nie daje się odczytać: %1; oczekiwano sprawozdania PDF</translation>
    </message>
    <message>
        <source>this is not a PDF; expected a report PDF of this program</source>
        <translation>to nie PDF; oczekiwano sprawozdania PDF tego programu</translation>
    </message>
    <message>
        <source>this PDF cannot be read (%1); expected a report PDF of this program</source>
        <translation>tego pliku PDF nie da się odczytać (%1); oczekiwano sprawozdania PDF tego programu</translation>
    </message>
    <message>
        <source>this PDF carries no exchange data (%1); expected a report PDF of this program that is not an archive (PDF/A) copy</source>
        <translation>ten PDF nie zawiera danych wymiany (%1); oczekiwano sprawozdania PDF tego programu, które nie jest kopią archiwalną (PDF/A)</translation>
    </message>
    <message>
        <source>What the readings cannot tell</source>
        <translation>Czego odczyty nie określają</translation>
    </message>
    <message>
        <source>Deviation, polar</source>
        <translation>Dewiacja, wykres biegunowy</translation>
    </message>
    <message>
        <source>Spectrum of deviation</source>
        <translation>Widmo dewiacji</translation>
    </message>
    <message>
        <source>Deviation and residuals against heading</source>
        <translation>Dewiacja i reszty w funkcji kursu</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Podpisy</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nazwisko</translation>
    </message>
    <message>
        <source>date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>signature</source>
        <translation>podpis</translation>
    </message>
    <message>
        <source>Signs and methods</source>
        <translation>Znaki i metody</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>W NORMIE</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>POZA NORMĄ</translation>
    </message>
    <message>
        <source>NO LIMIT SET</source>
        <translation>NORMY NIE USTALONO</translation>
    </message>
    <message>
        <source>Largest deviation %1 at %2 magnetic; spread (maximum − minimum) %3°.</source>
        <translation>Największa dewiacja %1 na kursie magnetycznym %2; rozpiętość (maksimum − minimum) %3°.</translation>
    </message>
    <message>
        <source>%1 No limit is set for this compass.</source>
        <translation>%1 Dla tej busoli nie ustalono wartości dopuszczalnej.</translation>
    </message>
    <message>
        <source>%1 Limit: %2</source>
        <translation>%1 Dopuszczalne: %2</translation>
    </message>
    <message>
        <source>Since %1</source>
        <translation>Od %1</translation>
    </message>
    <message>
        <source>the deviation has changed by (°) %1; coefficients by (°) %2</source>
        <translation>dewiacja zmieniła się o (°) %1; współczynniki o (°) %2</translation>
    </message>
    <message>
        <source>Performed</source>
        <translation>Wykonał</translation>
    </message>
    <message>
        <source>Inspected</source>
        <translation>Sprawdził</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Dopuścił</translation>
    </message>
    <message>
        <source>signed %1 · hash %2</source>
        <translation>podpisano %1 · skrót %2</translation>
    </message>
    <message>
        <source>no longer holds: changed after it</source>
        <translation>już nie obowiązuje: później zmieniono</translation>
    </message>
    <message>
        <source>Datum reader</source>
        <translation>Odczytujący wzorzec</translation>
    </message>
    <message>
        <source>Cockpit reader</source>
        <translation>Odczytujący w kabinie</translation>
    </message>
    <message>
        <source>Adjuster</source>
        <translation>Kompensujący</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Kontroler</translation>
    </message>
    <message>
        <source>|deviation| ≤&#xa0;%1</source>
        <translation>|dewiacja| ≤&#xa0;%1</translation>
    </message>
    <message>
        <source>spread ≤&#xa0;%1</source>
        <translation>rozpiętość ≤&#xa0;%1</translation>
    </message>
    <message>
        <source>issue</source>
        <translation>wydanie</translation>
    </message>
    <message>
        <source>%1, no document named</source>
        <translation>%1, nie podano dokumentu</translation>
    </message>
    <message>
        <source>Compass swing report</source>
        <translation>Sprawozdanie z pomiaru dewiacji busoli</translation>
    </message>
    <message>
        <source>The plots are based in part on the work of the Qwt project (http://qwt.sf.net).</source>
        <translation>Wykresy oparto częściowo na pracy projektu Qwt (http://qwt.sf.net).</translation>
    </message>
    <message>
        <source>built %1</source>
        <translation>rok budowy %1</translation>
    </message>
    <message>
        <source>serial no.</source>
        <translation>nr seryjny</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>użytkownik</translation>
    </message>
    <message>
        <source>compensator:</source>
        <translation>kompensator:</translation>
    </message>
    <message>
        <source>part no.</source>
        <translation>nr części</translation>
    </message>
    <message>
        <source>read to %1°</source>
        <translation>odczyt co %1°</translation>
    </message>
    <message>
        <source>date not stated</source>
        <translation>nie podano daty</translation>
    </message>
    <message>
        <source>%1 (UTC)</source>
        <translation>%1 (UTC)</translation>
    </message>
    <message>
        <source>%1 to %2 UTC</source>
        <translation>%1 do %2 UTC</translation>
    </message>
    <message>
        <source>%1, not yet signed</source>
        <translation>%1, jeszcze niepodpisany</translation>
    </message>
    <message>
        <source>revision %1</source>
        <translation>wydanie %1</translation>
    </message>
    <message>
        <source>procedure</source>
        <translation>metoda</translation>
    </message>
    <message>
        <source>work order</source>
        <translation>zlecenie</translation>
    </message>
    <message>
        <source>reason:</source>
        <translation>powód:</translation>
    </message>
    <message>
        <source>variation %1° (east +)</source>
        <translation>deklinacja %1° (wschodnia +)</translation>
    </message>
    <message>
        <source>class 1 (0.1°)</source>
        <translation>klasa 1 (0,1°)</translation>
    </message>
    <message>
        <source>class 2 (0.25°)</source>
        <translation>klasa 2 (0,25°)</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>świadectwo</translation>
    </message>
    <message>
        <source>valid to</source>
        <translation>ważne do</translation>
    </message>
    <message>
        <source>lines painted</source>
        <translation>linie namalowano</translation>
    </message>
    <message>
        <source>lines painted %1</source>
        <translation>linie namalowano %1</translation>
    </message>
    <message>
        <source>%1 with variation %2°: add %3° to their figures</source>
        <translation>%1 przy deklinacji %2°: do ich wartości dodaj %3°</translation>
    </message>
    <message>
        <source>magnetic headings made from true ones with variation %1° (east +)</source>
        <translation>kursy magnetyczne z rzeczywistych przy deklinacji %1° (wschodnia +)</translation>
    </message>
    <message>
        <source>elevation %1 m</source>
        <translation>wzniesienie %1 m</translation>
    </message>
    <message>
        <source>calibration due</source>
        <translation>wzorcowanie do</translation>
    </message>
    <message>
        <source>datum</source>
        <translation>wzorzec</translation>
    </message>
    <message>
        <source>cockpit</source>
        <translation>kabina</translation>
    </message>
    <message>
        <source>adjuster</source>
        <translation>kompensujący</translation>
    </message>
    <message>
        <source>inspector</source>
        <translation>kontroler</translation>
    </message>
    <message>
        <source>none set</source>
        <translation>nie ustalono</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Statek powietrzny</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Kompasowy</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Pomiar</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Miejsce</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Konfiguracja</translation>
    </message>
    <message>
        <source>Datum</source>
        <translation>Wzorzec</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Dopuszczalne</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Nastawienie</translation>
    </message>
    <message>
        <source>after these readings A = %1° was taken out by turning the compass; the deviations of the table are as read, results, plots and card as it stands since</source>
        <translation>po tych odczytach A = %1° usunięto przez obrót busoli; dewiacje w tabeli są jak odczytano, a wyniki, wykresy i tablica dotyczą jej obecnego ustawienia</translation>
    </message>
    <message>
        <source>In spite of</source>
        <translation>Mimo</translation>
    </message>
    <message>
        <source>Amends</source>
        <translation>Zmienia</translation>
    </message>
    <message>
        <source>record</source>
        <translation>zapis</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>none: a cardinal point has no reading near enough.</source>
        <translation>brak: któryś punkt główny nie ma dość bliskiego odczytu.</translation>
    </message>
    <message>
        <source>from the readings nearest to N, E, S, W by %1 heading: A mean of the four, B = (E − W)/2, C = (N − S)/2, E = ((N + S) − (E + W))/4; D cannot be told.</source>
        <translation>z odczytów najbliższych N, E, S, W według kursu (%1): A to średnia z czterech, B = (E − W)/2, C = (N − S)/2, E = ((N + S) − (E + W))/4; D nie da się określić.</translation>
    </message>
    <message>
        <source>from the readings nearest to the eight points by %1 heading: A mean of the eight, B = (E − W)/2, C = (N − S)/2, D = ((NE + SW) − (SE + NW))/4, E = ((N + S) − (E + W))/4.</source>
        <translation>z odczytów najbliższych ośmiu punktom według kursu (%1): A to średnia z ośmiu, B = (E − W)/2, C = (N − S)/2, D = ((NE + SW) − (SE + NW))/4, E = ((N + S) − (E + W))/4.</translation>
    </message>
    <message>
        <source>fast Fourier transform of equally spaced headings</source>
        <translation>szybkie przekształcenie Fouriera równoodległych kursów</translation>
    </message>
    <message>
        <source>least squares on headings that are not equally spaced</source>
        <translation>najmniejsze kwadraty na kursach nierównoodległych</translation>
    </message>
    <message>
        <source>harmonics of deviation against magnetic heading by %1, up to order %2, which is what these headings resolve.</source>
        <translation>harmoniczne dewiacji względem kursu magnetycznego; metoda: %1, do rzędu %2, który te kursy rozróżniają.</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Znak</translation>
    </message>
    <message>
        <source>Deviation = magnetic heading − compass heading; easterly is positive: the compass reads low, and deviation is added to what it reads to get magnetic heading.</source>
        <translation>Dewiacja = kurs magnetyczny − kurs kompasowy; wschodnia dodatnia: busola wskazuje za mało, a dewiację dodaje się do jej wskazania, aby otrzymać kurs magnetyczny.</translation>
    </message>
    <message>
        <source>Approximate</source>
        <translation>Przybliżone</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Dokładne</translation>
    </message>
    <message>
        <source>tan δ = (A + B sin ψ + C cos ψ + D sin 2ψ + E cos 2ψ) / (1 + B cos ψ − C sin ψ + D cos 2ψ − E sin 2ψ), multiplied out and fitted by linear least squares; ψ is the magnetic heading, A to E have no unit.</source>
        <translation>tan δ = (A + B sin ψ + C cos ψ + D sin 2ψ + E cos 2ψ) / (1 + B cos ψ − C sin ψ + D cos 2ψ − E sin 2ψ), wymnożone i dopasowane liniową metodą najmniejszych kwadratów; ψ to kurs magnetyczny, A do E nie mają jednostki.</translation>
    </message>
    <message>
        <source>Point rules</source>
        <translation>Reguły punktowe</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Błędy</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Widmo</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominalny</translation>
    </message>
    <message>
        <source>Magnetic</source>
        <translation>Magnetyczny</translation>
    </message>
    <message>
        <source>east +</source>
        <translation>wsch. +</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>przybliżone</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>dokładne</translation>
    </message>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>studentised</source>
        <translation>studentyzowana</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>EXCLUDED: %1</source>
        <translation>POMINIĘTY: %1</translation>
    </message>
    <message>
        <source>not complete, not used</source>
        <translation>niepełny, nie liczy się</translation>
    </message>
    <message>
        <source>SUSPECT, used</source>
        <translation>WĄTPLIWY, liczy się</translation>
    </message>
    <message>
        <source>A  constant</source>
        <translation>A  stały</translation>
    </message>
    <message>
        <source>B  sin</source>
        <translation>B  sin</translation>
    </message>
    <message>
        <source>C  cos</source>
        <translation>C  cos</translation>
    </message>
    <message>
        <source>D  sin 2×</source>
        <translation>D  sin 2×</translation>
    </message>
    <message>
        <source>E  cos 2×</source>
        <translation>E  cos 2×</translation>
    </message>
    <message>
        <source>%1 points, %2</source>
        <translation>%1 punktów, %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>compass heading</source>
        <translation>kurs kompasowy</translation>
    </message>
    <message>
        <source>magnetic heading</source>
        <translation>kurs magnetyczny</translation>
    </message>
    <message>
        <source>as an angle</source>
        <translation>jako kąt</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Odczyty</translation>
    </message>
    <message>
        <source>Coefficients</source>
        <translation>Współczynniki</translation>
    </message>
    <message>
        <source>Quality of the fits</source>
        <translation>Jakość dopasowań</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Dopasowanie</translation>
    </message>
    <message>
        <source>Argument</source>
        <translation>Argument</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Dopasowane</translation>
    </message>
    <message>
        <source>coefficients</source>
        <translation>współczynniki</translation>
    </message>
    <message>
        <source>Degrees of</source>
        <translation>Stopnie</translation>
    </message>
    <message>
        <source>freedom</source>
        <translation>swobody</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>śr. kw.</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>reszta</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Największa</translation>
    </message>
    <message>
        <source>Sigma of a</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>odczytu</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Uwarun-</translation>
    </message>
    <message>
        <source>number</source>
        <translation>kowanie</translation>
    </message>
    <message>
        <source>Parameters of the sensor model</source>
        <translation>Parametry modelu czujnika</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametr</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>do przodu</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>na prawą burtę</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>down</source>
        <translation>w dół</translation>
    </message>
    <message>
        <source>Soft iron a, b, c</source>
        <translation>Żelazo miękkie a, b, c</translation>
    </message>
    <message>
        <source>Soft iron d, e, f</source>
        <translation>Żelazo miękkie d, e, f</translation>
    </message>
    <message>
        <source>Soft iron g, h, k</source>
        <translation>Żelazo miękkie g, h, k</translation>
    </message>
    <message>
        <source>Hard iron P, Q, R</source>
        <translation>Żelazo twarde P, Q, R</translation>
    </message>
    <message>
        <source>Soft constants</source>
        <translation>Stałe składowe miękkie</translation>
    </message>
    <message>
        <source>%1, %2 A, %3</source>
        <translation>%1, %2 A, %3</translation>
    </message>
    <message>
        <source>Misalignment: roll, pitch, yaw</source>
        <translation>Niewspółosiowość: przechylenie, pochylenie, odchylenie</translation>
    </message>
    <message>
        <source>Its coefficients in the field of this swing</source>
        <translation>Jego współczynniki w polu tego pomiaru</translation>
    </message>
    <message>
        <source>As an angle</source>
        <translation>Jako kąt</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>Pochodzi z</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>W użyciu</translation>
    </message>
    <message>
        <source>the swing keeps no field of the Earth&apos;s; without H and dip the model has neither coefficients nor a map</source>
        <translation>pomiar nie ma zapisanego pola Ziemi; bez H i inklinacji model nie ma ani współczynników, ani mapy</translation>
    </message>
    <message>
        <source>Directive force</source>
        <translation>Siła kierująca</translation>
    </message>
    <message>
        <source>λ = %1: mean horizontal field at the sensor as a part of H</source>
        <translation>λ = %1: średnie pole poziome przy czujniku jako część H</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Kąty</translation>
    </message>
    <message>
        <source>there is no fit, and no errors of it.</source>
        <translation>nie ma dopasowania ani jego błędów.</translation>
    </message>
    <message>
        <source>Suspect: a slip of reading or writing is likely, by Bayes&apos; rule over the usual slips; a suspect reading stays in use until somebody excludes it with a reason. t is the externally studentised residual.</source>
        <translation>Wątpliwy: według reguły Bayesa zastosowanej do zwykłych pomyłek prawdopodobny jest błąd odczytu lub zapisu; wątpliwy odczyt liczy się, dopóki ktoś nie pominie go z podaniem powodu. t to zewnętrznie studentyzowana reszta.</translation>
    </message>
    <message>
        <source>the standard errors are those of the smallest division alone: there are no more readings than coefficients, and no interval can be given.</source>
        <translation>błędy standardowe wynikają z samej działki odczytu: odczytów nie jest więcej niż współczynników i przedziału nie da się podać.</translation>
    </message>
    <message>
        <source>standard errors are of the scatter about the fit, and never less than the smallest division leaves. 95 % ± is the half width of the interval that holds the true value 95 times in 100: %1 standard errors (Student).</source>
        <translation>błędy standardowe wynikają z rozrzutu wokół dopasowania i nigdy nie są mniejsze, niż pozostawia działka odczytu. 95 % ± to połowa szerokości przedziału, który obejmuje wartość prawdziwą 95 razy na 100: %1 błędów standardowych (Student).</translation>
    </message>
    <message>
        <source>std. error</source>
        <translation>błąd std.</translation>
    </message>
    <message>
        <source>95 % ±</source>
        <translation>95 % ±</translation>
    </message>
    <message>
        <source>the card has no headings; expected one every 10°, 15°, 30° or 45°</source>
        <translation>tablica nie ma kursów; oczekiwano co 10°, 15°, 30° lub 45°</translation>
    </message>
    <message>
        <source>the two STEER columns are made in different ways; expected the same headings and the same method</source>
        <translation>obie kolumny STEER sporządzono różnie; oczekiwano tych samych kursów i tej samej metody</translation>
    </message>
    <message>
        <source>the two STEER columns are of different compasses; expected two swings of one compass of one aircraft</source>
        <translation>obie kolumny STEER dotyczą różnych busol; oczekiwano dwóch pomiarów jednej busoli jednego statku powietrznego</translation>
    </message>
    <message>
        <source>the two STEER columns are both “%1”; expected columns that can be told apart</source>
        <translation>obie kolumny STEER to „%1”; oczekiwano kolumn, które można odróżnić</translation>
    </message>
    <message>
        <source>It holds in the attitude in which it was swung, which was not level, and in the configuration that it names.</source>
        <translation>Obowiązuje w położeniu, w jakim wykonano pomiar (nie poziomym), i w podanej konfiguracji.</translation>
    </message>
    <message>
        <source>It holds for level flight in the configuration that it names.</source>
        <translation>Obowiązuje w locie poziomym w podanej konfiguracji.</translation>
    </message>
    <message>
        <source>It holds in the configuration that it names; the attitude in which it was swung is not stated.</source>
        <translation>Obowiązuje w podanej konfiguracji; położenia podczas pomiaru nie podano.</translation>
    </message>
    <message>
        <source>Print at 100 %, check the line of 50 mm, cut along the marks, fix it on or near the compass and take the old card away. %1 Between two headings, interpolate.</source>
        <translation>Drukuj w skali 100 %, sprawdź linię 50 mm, wytnij po znakach, umieść na busoli lub przy niej i usuń starą tablicę. %1 Między dwoma kursami interpoluj.</translation>
    </message>
    <message>
        <source>record %1, data SHA-256 %2</source>
        <translation>zapis %1, dane SHA-256 %2</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Jakość</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>nothing: as found, before any adjustment</source>
        <translation>nic: stan zastany, przed jakąkolwiek kompensacją</translation>
    </message>
    <message>
        <source>The figures before rounding, and half-way to the next row</source>
        <translation>Liczby przed zaokrągleniem i w połowie drogi do następnego wiersza</translation>
    </message>
    <message>
        <source>COMPASS</source>
        <translation>BUSOLA</translation>
    </message>
    <message>
        <source>MAGNETIC</source>
        <translation>MAGNETYCZNY</translation>
    </message>
    <message>
        <source>95 % band</source>
        <translation>pas 95 %</translation>
    </message>
    <message>
        <source>±</source>
        <translation>±</translation>
    </message>
    <message>
        <source>Half-way</source>
        <translation>W połowie</translation>
    </message>
    <message>
        <source>by the curve</source>
        <translation>z krzywej</translation>
    </message>
    <message>
        <source>Interpolated</source>
        <translation>Interpolowane</translation>
    </message>
    <message>
        <source>is off by</source>
        <translation>różni się o</translation>
    </message>
    <message>
        <source>Next swing due %1</source>
        <translation>Następny pomiar: %1</translation>
    </message>
    <message>
        <source>When the compass reads COMPASS, the magnetic heading is MAGNETIC.</source>
        <translation>Gdy busola wskazuje BUSOLA, kurs magnetyczny wynosi MAGNETYCZNY.</translation>
    </message>
    <message>
        <source>DRAFT</source>
        <translation>SZKIC</translation>
    </message>
    <message>
        <source>STEER</source>
        <translation>STERUJ</translation>
    </message>
    <message>
        <source>Performed %1</source>
        <translation>Wykonał %1</translation>
    </message>
    <message>
        <source>Inspected %1</source>
        <translation>Sprawdził %1</translation>
    </message>
    <message>
        <source>Released %1</source>
        <translation>Dopuścił %1</translation>
    </message>
    <message>
        <source>%1 to %2°</source>
        <translation>%1 do %2°</translation>
    </message>
    <message>
        <source>%1: DRAFT — NOT SIGNED</source>
        <translation>%1: SZKIC — NIEPODPISANY</translation>
    </message>
    <message>
        <source>AMENDED SINCE: NOT VALID</source>
        <translation>PÓŹNIEJ ZMIENIONO: NIEWAŻNE</translation>
    </message>
    <message>
        <source>%1: AMENDED SINCE, NOT VALID</source>
        <translation>%1: PÓŹNIEJ ZMIENIONO, NIEWAŻNE</translation>
    </message>
    <message>
        <source>Record %1%2 · data %3 · %4</source>
        <translation>Zapis %1%2 · dane %3 · %4</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>podpisany</translation>
    </message>
    <message>
        <source>Not signed: figures without %1, which was taken out after what was signed</source>
        <translation>Niepodpisane: liczby bez %1, usuniętego po tym, co podpisano</translation>
    </message>
    <message>
        <source>Not signed: the record is not what was signed</source>
        <translation>Niepodpisane: zapis nie jest tym, co podpisano</translation>
    </message>
    <message>
        <source>Not signed: a draft</source>
        <translation>Niepodpisane: szkic</translation>
    </message>
    <message>
        <source>Not signed: complete, signatures are wanting</source>
        <translation>Niepodpisane: ukończone, brak podpisów</translation>
    </message>
    <message>
        <source>Signed before signatures were kept</source>
        <translation>Podpisane, zanim przechowywano podpisy</translation>
    </message>
    <message>
        <source>By the exact fit</source>
        <translation>Z dopasowania dokładnego</translation>
    </message>
    <message>
        <source>By the nearest reading</source>
        <translation>Z najbliższego odczytu</translation>
    </message>
    <message>
        <source>%1, 95 % band ±%2°</source>
        <translation>%1, pas 95 % ±%2°</translation>
    </message>
    <message>
        <source>%1, band not known</source>
        <translation>%1, pas nieznany</translation>
    </message>
    <message>
        <source>Largest residual %1; largest reading %2</source>
        <translation>Największa reszta %1; największy odczyt %2</translation>
    </message>
    <message>
        <source>! OVER THE LIMIT of %1</source>
        <translation>! PONAD GRANICĘ %1</translation>
    </message>
    <message>
        <source>* nobody read between (compass) %1</source>
        <translation>* nikt nie odczytał między (busola) %1</translation>
    </message>
    <message>
        <source>SUSPECT reading used, on %1</source>
        <translation>Użyto PODEJRZANEGO odczytu na %1</translation>
    </message>
    <message>
        <source>NOT LEVEL: pitch %1, roll %2</source>
        <translation>NIE W POZIOMIE: pochylenie %1, przechylenie %2</translation>
    </message>
    <message>
        <source>Between rows up to %1° off</source>
        <translation>Między wierszami różnica do %1°</translation>
    </message>
    <message>
        <source>%1: better every %2°</source>
        <translation>%1: lepiej co %2°</translation>
    </message>
    <message>
        <source>Without %1, taken out after the swing</source>
        <translation>Bez %1, usuniętego po pomiarze</translation>
    </message>
    <message>
        <source>MAGNETIC = COMPASS + deviation, to whole degrees; %1%2</source>
        <translation>MAGNETYCZNY = BUSOLA + dewiacja, do pełnych stopni; %1%2</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>normal %1, reversed %2, mean %3</source>
        <translation>normalnie %1, odwrotnie %2, średnio %3</translation>
    </message>
    <message>
        <source>N–S %1°, E–W %2°, index %3°; pairs 0/180 %4°, 90/270 %5°: %6</source>
        <translation>N–S %1°, E–W %2°, indeks %3°; pary 0/180 %4°, 90/270 %5°: %6</translation>
    </message>
    <message>
        <source>agree within 0.2° (TM 11-4920-292-15)</source>
        <translation>zgodne w granicach 0,2° (TM 11-4920-292-15)</translation>
    </message>
    <message>
        <source>DO NOT AGREE within 0.2° (TM 11-4920-292-15)</source>
        <translation>NIEZGODNE w granicach 0,2° (TM 11-4920-292-15)</translation>
    </message>
    <message>
        <source>not made</source>
        <translation>nie wykonano</translation>
    </message>
    <message>
        <source>largest %1′, mean %2′: %3</source>
        <translation>największy %1′, średni %2′: %3</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>zaliczone</translation>
    </message>
    <message>
        <source>NOT PASSED</source>
        <translation>NIEZALICZONE</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>North–south line</source>
        <translation>Linia północ–południe</translation>
    </message>
    <message>
        <source>Calibrator</source>
        <translation>Kalibrator</translation>
    </message>
    <message>
        <source>Sensor sheet</source>
        <translation>Karta czujnika</translation>
    </message>
    <message>
        <source>E1</source>
        <translation>E1</translation>
    </message>
    <message>
        <source>E2</source>
        <translation>E2</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Pokrętła</translation>
    </message>
    <message>
        <source>MISAL %1, δ180 %2, δ270 %3</source>
        <translation>MISAL %1, δ180 %2, δ270 %3</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>Self-check</source>
        <translation>Samosprawdzenie</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwarte</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>Table F1</source>
        <translation>Tabela F1</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Nastawiony</translation>
    </message>
    <message>
        <source>indicated</source>
        <translation>wskazany</translation>
    </message>
    <message>
        <source>error</source>
        <translation>błąd</translation>
    </message>
    <message>
        <source>The headings</source>
        <translation>Kursy</translation>
    </message>
    <message>
        <source>Electrical</source>
        <translation>Elektrycznie</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Stół obrotowy</translation>
    </message>
    <message>
        <source>Signed by hand; performer and inspector are two people</source>
        <translation>Podpisy odręczne; wykonawca i kontroler to dwie osoby</translation>
    </message>
    <message>
        <source>role</source>
        <translation>rola</translation>
    </message>
    <message>
        <source>name, licence</source>
        <translation>nazwisko, licencja</translation>
    </message>
    <message>
        <source>date (UTC)</source>
        <translation>data (UTC)</translation>
    </message>
    <message>
        <source>Performer</source>
        <translation>Wykonawca</translation>
    </message>
    <message>
        <source>Electrical swing: record</source>
        <translation>Pomiar elektryczny: protokół</translation>
    </message>
    <message>
        <source>NOT FINISHED: OPEN POINTS</source>
        <translation>NIEUKOŃCZONE: OTWARTE PUNKTY</translation>
    </message>
    <message>
        <source>On this sheet error = indicated − selected; deviation (magnetic − compass, easterly positive) is its negative.</source>
        <translation>Na tej karcie błąd = wskazany − nastawiony; dewiacja (magnetyczny − busoli, wschodnia dodatnia) ma znak przeciwny.</translation>
    </message>
    <message>
        <source>read as found</source>
        <translation>odczyt w stanie zastanym</translation>
    </message>
    <message>
        <source>then zero the compensator: dots on the screws in line with those on the case; from here on nothing is as found</source>
        <translation>potem wyzeruj kompensator: kropki na śrubach naprzeciw kropek na obudowie; odtąd nic nie jest w stanie zastanym</translation>
    </message>
    <message>
        <source>done ____</source>
        <translation>wykonano ____</translation>
    </message>
    <message>
        <source>Only where the compensator is to be zeroed: after the readings as found</source>
        <translation>Tylko gdy kompensator ma być wyzerowany: po odczytach stanu zastanego</translation>
    </message>
    <message>
        <source>datum °</source>
        <translation>wzorzec °</translation>
    </message>
    <message>
        <source>compass °</source>
        <translation>busola °</translation>
    </message>
    <message>
        <source>adjusted by (performer)</source>
        <translation>kompensował (wykonawca)</translation>
    </message>
    <message>
        <source>Inspector: another person than who adjusted</source>
        <translation>Kontroler: inna osoba niż ta, która kompensowała</translation>
    </message>
    <message>
        <source>inspected by</source>
        <translation>sprawdził</translation>
    </message>
    <message>
        <source>licence, stamp</source>
        <translation>licencja, pieczęć</translation>
    </message>
    <message>
        <source>%1° (from %2° to %3°)</source>
        <translation>%1° (od %2° do %3°)</translation>
    </message>
    <message>
        <source>, over %1 of 8 headings only</source>
        <translation>, tylko na %1 z 8 kursów</translation>
    </message>
    <message>
        <source>before compensation %1</source>
        <translation>przed kompensacją %1</translation>
    </message>
    <message>
        <source>within</source>
        <translation>w granicach</translation>
    </message>
    <message>
        <source>BEYOND</source>
        <translation>POZA</translation>
    </message>
    <message>
        <source>residual swing %1: %2 the %3° that are allowed (TM 1-1500-204-23-4)</source>
        <translation>pomiar końcowy %1: %2 dopuszczalnych %3° (TM 1-1500-204-23-4)</translation>
    </message>
    <message>
        <source>signed before signatures were kept</source>
        <translation>podpisane, zanim przechowywano podpisy</translation>
    </message>
    <message>
        <source>signed %1</source>
        <translation>podpisano %1</translation>
    </message>
    <message>
        <source>none is known: columns (1) and (2) are empty</source>
        <translation>nieznana: kolumny (1) i (2) są puste</translation>
    </message>
    <message>
        <source>as the guided swing of this record read it, before any control was turned</source>
        <translation>jak odczytał pomiar prowadzony tego zapisu, przed obróceniem czegokolwiek</translation>
    </message>
    <message>
        <source>record %1</source>
        <translation>zapis %1</translation>
    </message>
    <message>
        <source>data %1</source>
        <translation>dane %1</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Rozrzut</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>every figure is of the reading nearest to its heading, within 22.5°; a placard by the fit may differ by how far that reading lies off the curve</source>
        <translation>każda liczba pochodzi z odczytu najbliższego kursowi, w granicach 22,5°; tablica z dopasowania może się różnić o odległość tego odczytu od krzywej</translation>
    </message>
    <message>
        <source>on this sheet, as on the form: DEV = compass − magnetic, positive where the compass reads more. The deviation of all other documents, and of the remarks, is magnetic − compass, easterly positive.</source>
        <translation>na tej karcie, jak na formularzu: DEV = busola − magnetyczny, dodatnia, gdy busola wskazuje więcej. Dewiacja we wszystkich innych dokumentach i w uwagach to magnetyczny − busola, wschodnia dodatnia.</translation>
    </message>
    <message>
        <source>swung %1</source>
        <translation>pomiar %1</translation>
    </message>
    <message>
        <source>by the nearest reading</source>
        <translation>z najbliższego odczytu</translation>
    </message>
    <message>
        <source>Mean deviation and spread against magnetic heading</source>
        <translation>Średnia dewiacja i rozrzut względem kursu magnetycznego</translation>
    </message>
    <message>
        <source>How the figures were made</source>
        <translation>Jak powstały liczby</translation>
    </message>
    <message>
        <source>In short</source>
        <translation>W skrócie</translation>
    </message>
    <message>
        <source>The same, polar</source>
        <translation>To samo biegunowo</translation>
    </message>
    <message>
        <source>swung at</source>
        <translation>miejsce pomiaru</translation>
    </message>
    <message>
        <source>based at</source>
        <translation>baza</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>all swings</source>
        <translation>wszystkie pomiary</translation>
    </message>
    <message>
        <source>%1 swings of %2 aircraft are used, of %3 in the selection.</source>
        <translation>Użyto pomiarów: %1, statków powietrznych: %2, z wyboru %3.</translation>
    </message>
    <message>
        <source>The mean deviation is highest at %1 and lowest at %2.</source>
        <translation>Średnia dewiacja jest największa na %1, najmniejsza na %2.</translation>
    </message>
    <message>
        <source>Aircraft differ most at %1.</source>
        <translation>Statki powietrzne różnią się najbardziej na %1.</translation>
    </message>
    <message>
        <source>Of %1 pairs of swings (as left, next as found) %2 were beyond the limit when found: %3 % (%4 to %5 % at 95 % confidence).</source>
        <translation>Z %1 par pomiarów (pozostawiony, następny zastany) %2 przekraczało granicę w stanie zastanym: %3 % (od %4 do %5 % przy ufności 95 %).</translation>
    </message>
    <message>
        <source>No jump is told at a false discovery rate of 10 %.</source>
        <translation>Nie stwierdzono skoku przy odsetku fałszywych odkryć 10 %.</translation>
    </message>
    <message numerus="yes">
        <source>%n jump(s) told at a false discovery rate of 10 %.</source>
        <translation>
            <numerusform>Stwierdzono %n skok przy odsetku fałszywych odkryć 10 %.</numerusform>
            <numerusform>Stwierdzono %n skoki przy odsetku fałszywych odkryć 10 %.</numerusform>
            <numerusform>Stwierdzono %n skoków przy odsetku fałszywych odkryć 10 %.</numerusform>
        </translation>
    </message>
    <message>
        <source>Swing next: %1 · %2, %3 % to be out of limits by %4 (%5).</source>
        <translation>Następny pomiar: %1 · %2, %3 % na przekroczenie granic do %4 (%5).</translation>
    </message>
    <message>
        <source>One aircraft has one vote: the mean of its swings.</source>
        <translation>Jeden statek powietrzny ma jeden głos: średnią swoich pomiarów.</translation>
    </message>
    <message>
        <source>Each swing has one vote; aircraft with many swings weigh more.</source>
        <translation>Każdy pomiar ma jeden głos; statki powietrzne o wielu pomiarach ważą więcej.</translation>
    </message>
    <message>
        <source>A reading enters a heading of the grid moved along its own swing&apos;s curve, its residual kept; a swing without a reading within half a step enters by its curve.</source>
        <translation>Odczyt wchodzi na kurs siatki przesunięty wzdłuż krzywej własnego pomiaru, z zachowaną resztą; pomiar bez odczytu w pół kroku wchodzi swoją krzywą.</translation>
    </message>
    <message>
        <source>Spread as found: standard deviation of what was read. Between aircraft: the same with the fits&apos; own error taken out.</source>
        <translation>Rozrzut zastany: odchylenie standardowe odczytów. Między statkami powietrznymi: to samo po odjęciu błędu samych dopasowań.</translation>
    </message>
    <message>
        <source>Exceedance is told from pairs: a compass as left, and the same compass as found next. The interval is exact (Clopper and Pearson).</source>
        <translation>Przekroczenia podaje się z par: busola pozostawiona i ta sama busola zastana następnym razem. Przedział jest dokładny (Clopper i Pearson).</translation>
    </message>
    <message>
        <source>Expected share: chance that the largest deviation over all headings of the next swing is beyond the limit, by Student&apos;s prediction from those that were found.</source>
        <translation>Udział oczekiwany: szansa, że największa dewiacja na wszystkich kursach następnego pomiaru przekroczy granicę, według predykcji Studenta z zastanych.</translation>
    </message>
    <message>
        <source>Three-sigma share: mean and standard deviation of the worst single heading taken as if they were known, as in the source paper; too small for few swings and for many headings.</source>
        <translation>Udział 3σ: średnia i odchylenie standardowe najgorszego pojedynczego kursu wzięte za znane, jak w pracy źródłowej; za mały przy niewielu pomiarach i wielu kursach.</translation>
    </message>
    <message>
        <source>Variance components by restricted maximum likelihood; intervals by profile of the likelihood at 95 %.</source>
        <translation>Składowe wariancji metodą największej wiarygodności z ograniczeniami (REML); przedziały z profilu wiarygodności, 95 %.</translation>
    </message>
    <message>
        <source>A jump&apos;s date is the interval between two swings. One in ten of the jumps that are told may be false.</source>
        <translation>Datą skoku jest przedział między dwoma pomiarami. Jeden na dziesięć podanych skoków może być fałszywy.</translation>
    </message>
    <message>
        <source>Who next: chance of being out of limits at some time up to the date, by level, drift and wander of each coefficient since the last swing, shrunk to its type.</source>
        <translation>Kto następny: szansa przekroczenia granic kiedykolwiek do tego dnia, z poziomu, dryfu i wędrowania każdego współczynnika od ostatniego pomiaru, ściągnięta ku typowi.</translation>
    </message>
    <message>
        <source>Pattern of the population by magnetic heading</source>
        <translation>Wzorzec populacji według kursu magnetycznego</translation>
    </message>
    <message>
        <source>aircraft</source>
        <translation>statek powietrzny</translation>
    </message>
    <message>
        <source>swings</source>
        <translation>pomiary</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>odch. std.</translation>
    </message>
    <message>
        <source>between aircraft</source>
        <translation>między statkami powietrznymi</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>50 %</source>
        <translation>50 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Coefficients of the population</source>
        <translation>Współczynniki populacji</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>współczynnik</translation>
    </message>
    <message>
        <source>votes</source>
        <translation>głosy</translation>
    </message>
    <message>
        <source>standard error</source>
        <translation>błąd standardowy</translation>
    </message>
    <message>
        <source>far from the others</source>
        <translation>daleko od pozostałych</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Harmonics of the mean and of the standard deviation</source>
        <translation>Harmoniczne średniej i odchylenia standardowego</translation>
    </message>
    <message>
        <source>of</source>
        <translation>wielkość</translation>
    </message>
    <message>
        <source>order</source>
        <translation>rząd</translation>
    </message>
    <message>
        <source>sin</source>
        <translation>sin</translation>
    </message>
    <message>
        <source>cos</source>
        <translation>cos</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplituda</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>odchylenie standardowe</translation>
    </message>
    <message>
        <source>mean, as found</source>
        <translation>średnia, stan zastany</translation>
    </message>
    <message>
        <source>mean, as left</source>
        <translation>średnia, stan końcowy</translation>
    </message>
    <message>
        <source>Beyond the limit at the next inspection, from pairs</source>
        <translation>Poza granicą przy następnym przeglądzie, z par</translation>
    </message>
    <message>
        <source>pairs</source>
        <translation>pary</translation>
    </message>
    <message>
        <source>beyond</source>
        <translation>poza</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>zaobserwowane</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>przedział 95 %</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>oczekiwane</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Student</translation>
    </message>
    <message>
        <source>three sigma</source>
        <translation>trzy sigma</translation>
    </message>
    <message>
        <source>the paper&apos;s</source>
        <translation>według pracy</translation>
    </message>
    <message>
        <source>all</source>
        <translation>wszystkie</translation>
    </message>
    <message>
        <source>limit %1°</source>
        <translation>granica %1°</translation>
    </message>
    <message>
        <source>each its own limit</source>
        <translation>każda własna granica</translation>
    </message>
    <message>
        <source>type</source>
        <translation>typ</translation>
    </message>
    <message>
        <source>base</source>
        <translation>baza</translation>
    </message>
    <message>
        <source>crew</source>
        <translation>załoga</translation>
    </message>
    <message>
        <source>Where it comes from: standard deviations by component, with 95 % intervals</source>
        <translation>Skąd pochodzi: odchylenia standardowe składowych, z przedziałami 95 %</translation>
    </message>
    <message>
        <source>swing to swing</source>
        <translation>z pomiaru na pomiar</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nieokreślone</translation>
    </message>
    <message>
        <source>A as human error, by base and crew</source>
        <translation>A jako błąd ludzki, według bazy i załogi</translation>
    </message>
    <message>
        <source>mean A</source>
        <translation>średnie A</translation>
    </message>
    <message>
        <source>mean |A|</source>
        <translation>średnie |A|</translation>
    </message>
    <message>
        <source>Jumps, at a false discovery rate of 10 %</source>
        <translation>Skoki, przy odsetku fałszywych odkryć 10 %</translation>
    </message>
    <message>
        <source>between</source>
        <translation>między</translation>
    </message>
    <message>
        <source>by</source>
        <translation>przez</translation>
    </message>
    <message>
        <source>1 se</source>
        <translation>1 błąd std.</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>event, likely part</source>
        <translation>zdarzenie, prawdopodobna część</translation>
    </message>
    <message>
        <source>Drifts, at a false discovery rate of 10 %</source>
        <translation>Dryfy, przy odsetku fałszywych odkryć 10 %</translation>
    </message>
    <message>
        <source>a year</source>
        <translation>rocznie</translation>
    </message>
    <message>
        <source>Who next: out of limits before the next date</source>
        <translation>Kto następny: poza granicami przed następnym terminem</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>prawdopodobieństwo</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>największa</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>granica</translation>
    </message>
    <message>
        <source>last swing</source>
        <translation>ostatni pomiar</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>powód</translation>
    </message>
    <message>
        <source>The fleet by what is expected, as a share of the limit</source>
        <translation>Flota według oczekiwań, jako część wartości dopuszczalnej</translation>
    </message>
    <message>
        <source>largest expected deviation</source>
        <translation>największa oczekiwana dewiacja</translation>
    </message>
    <message>
        <source>compasses</source>
        <translation>busole</translation>
    </message>
    <message>
        <source>up to a quarter</source>
        <translation>do jednej czwartej</translation>
    </message>
    <message>
        <source>a quarter to a half</source>
        <translation>od ćwierci do połowy</translation>
    </message>
    <message>
        <source>a half to three quarters</source>
        <translation>od połowy do trzech czwartych</translation>
    </message>
    <message>
        <source>three quarters to the limit</source>
        <translation>od trzech czwartych do granicy</translation>
    </message>
    <message>
        <source>beyond the limit</source>
        <translation>poza granicą</translation>
    </message>
    <message>
        <source>OUT OF LIMITS</source>
        <translation>POZA GRANICAMI</translation>
    </message>
    <message>
        <source>%1: OUT OF LIMITS</source>
        <translation>%1: POZA GRANICAMI</translation>
    </message>
    <message>
        <source>NOT SIGNED</source>
        <translation>NIEPODPISANE</translation>
    </message>
    <message>
        <source>%1: NOT SIGNED</source>
        <translation>%1: NIEPODPISANE</translation>
    </message>
    <message>
        <source>signed, names not verified</source>
        <translation>podpisane, nazwisk nie sprawdzono</translation>
    </message>
    <message>
        <source>* not read on %1</source>
        <translation>* nie odczytano na %1</translation>
    </message>
    <message>
        <source>Standard soft-iron correction of a type: D and E, alike in all its aircraft</source>
        <translation>Standardowa poprawka typu na żelazo miękkie: D i E, jednakowe we wszystkich jego statkach powietrznych</translation>
    </message>
    <message>
        <source>next aircraft</source>
        <translation>następny statek</translation>
    </message>
    <message>
        <source>highest</source>
        <translation>największy</translation>
    </message>
    <message>
        <source>lowest</source>
        <translation>najmniejszy</translation>
    </message>
    <message>
        <source>Alarms of the control charts of A</source>
        <translation>Alarmy kart kontrolnych A</translation>
    </message>
    <message>
        <source>chart</source>
        <translation>karta</translation>
    </message>
    <message>
        <source>Swing in flight: legs by GPS</source>
        <translation>Pomiar dewiacji w locie: odcinki według GPS</translation>
    </message>
    <message>
        <source>Wind from %1° at %2 kt ± %3 kt, airspeed %4 kt ± %5 kt (one standard error).</source>
        <translation>Wiatr z %1°, %2 w ± %3 w, prędkość powietrzna %4 w ± %5 w (jeden błąd standardowy).</translation>
    </message>
    <message>
        <source>Ground velocity = air velocity + wind: at one airspeed in one air mass the ground velocities of three headings or more lie on a circle about the wind whose radius is the airspeed; the heading of each leg is that of ground velocity − wind.</source>
        <translation>Prędkość względem ziemi = prędkość powietrzna + wiatr: przy jednej prędkości powietrznej w jednej masie powietrza prędkości trzech lub więcej kursów leżą na okręgu wokół wiatru, którego promieniem jest prędkość powietrzna; kurs każdego odcinka to kierunek prędkości względem ziemi − wiatru.</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Odcinki</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Odcinek</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Kąt drogi</translation>
    </message>
    <message>
        <source>true</source>
        <translation>rzeczywisty</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Prędkość</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>ziemia</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Continuous swing in flight</source>
        <translation>Ciągły pomiar dewiacji w locie</translation>
    </message>
    <message>
        <source>%1 updates; innovations %2 times what the stated errors allow (1: as stated).</source>
        <translation>Aktualizacji: %1; innowacje są %2 razy większe, niż pozwalają podane błędy (1: jak podano).</translation>
    </message>
    <message>
        <source>δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′, followed by a Kalman filter; an alarm is raised by χ² of the last 10, 20, 40 and 80 innovations, falsely in one of ten logs of 1400 updates.</source>
        <translation>δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′, śledzone filtrem Kalmana; alarm podnosi χ² ostatnich 10, 20, 40 i 80 innowacji, fałszywie w jednym na dziesięć zapisów po 1400 aktualizacji.</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Błąd standardowy</translation>
    </message>
    <message>
        <source>Deviation = magnetic − compass, easterly positive; indication error = read − magnetic is its negative.</source>
        <translation>Dewiacja = kurs magnetyczny − kompasowy, wschodnia dodatnia; błąd wskazania = odczytany − magnetyczny ma znak przeciwny.</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Częstotliwość</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplituda</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Źródło</translation>
    </message>
    <message>
        <source>Folded from</source>
        <translation>Odbita z</translation>
    </message>
    <message>
        <source>Filter of %1 ms: notches %2 Hz, low-pass %3 Hz; above %4 Hz it leaves %5 of %6 %7 rms.</source>
        <translation>Filtr %1 ms: wycięcia %2 Hz, dolnoprzepustowy %3 Hz; powyżej %4 Hz zostawia %5 z %6 %7 (średnie kwadratowe).</translation>
    </message>
    <message>
        <source>Spectrum of a sensor&apos;s log</source>
        <translation>Widmo zapisu czujnika</translation>
    </message>
    <message>
        <source>Column %1 at %2 samples a second; Welch, %3 segments of %4 samples, periodic Hann window, half overlap, mean of each taken out; one-sided. A line stands above its neighbours&apos; middle by more than chance does once in a thousand spectra.</source>
        <translation>Kolumna %1, próbek na sekundę %2; Welch, segmentów %3 po %4 próbek, okresowe okno Hanna, zakładka połowy, średnia każdego odjęta; widmo jednostronne. Linia wystaje ponad środek sąsiadów bardziej, niż przypadek zdarza się raz na tysiąc widm.</translation>
    </message>
    <message>
        <source>Measured against applied</source>
        <translation>Zmierzone względem przyłożonego</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>scale, measured per applied</source>
        <translation>skala, zmierzone na przyłożone</translation>
    </message>
    <message>
        <source>its standard error</source>
        <translation>jej błąd standardowy</translation>
    </message>
    <message>
        <source>bias (nT)</source>
        <translation>przesunięcie (nT)</translation>
    </message>
    <message>
        <source>its standard error (nT)</source>
        <translation>jego błąd standardowy (nT)</translation>
    </message>
    <message>
        <source>per degree of temperature (nT/°C)</source>
        <translation>na stopień temperatury (nT/°C)</translation>
    </message>
    <message>
        <source>hysteresis, on the way up − down (nT)</source>
        <translation>histereza, w górę − w dół (nT)</translation>
    </message>
    <message>
        <source>nonlinearity, largest (nT)</source>
        <translation>nieliniowość, największa (nT)</translation>
    </message>
    <message>
        <source>noise, rms (nT)</source>
        <translation>szum, średni kwadratowy (nT)</translation>
    </message>
    <message>
        <source>Not at right angles: x and y by %1°, x and z by %2°, y and z by %3°. Mount: roll %4°, pitch %5°, yaw %6°.</source>
        <translation>Odchylenie od kąta prostego: x i y o %1°, x i z o %2°, y i z o %3°. Mocowanie: przechylenie %4°, pochylenie %5°, odchylenie %6°.</translation>
    </message>
    <message>
        <source>Sensor on the coil bench</source>
        <translation>Czujnik na stanowisku z cewkami</translation>
    </message>
    <message>
        <source>%1 samples, %2 used. measured = scale (axes) applied + bias + temperature + hysteresis + nonlinearity; scale is measured per applied.</source>
        <translation>Próbek %1, użyto %2. zmierzone = skala (osie) przyłożone + przesunięcie + temperatura + histereza + nieliniowość; skala to zmierzone na przyłożone.</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Czynności</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Czynność</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Najgorzej</translation>
    </message>
    <message>
        <source>at</source>
        <translation>w chwili</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Spełnia</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>tak</translation>
    </message>
    <message>
        <source>NO</source>
        <translation>NIE</translation>
    </message>
    <message>
        <source>Interference test of a sensor</source>
        <translation>Próba zakłóceń czujnika</translation>
    </message>
    <message>
        <source>Passes: no action changes the field by more than the limits.</source>
        <translation>Spełnia: żadna czynność nie zmienia pola bardziej, niż pozwalają granice.</translation>
    </message>
    <message>
        <source>Does not pass: an action changes the field by more than the limits.</source>
        <translation>Nie spełnia: któraś czynność zmienia pole bardziej, niż pozwalają granice.</translation>
    </message>
    <message>
        <source>Limits %1, %2 and %3 nT on x, y and z; noise before the first action %4, %5, %6 nT.</source>
        <translation>Granice %1, %2 i %3 nT na x, y i z; szum przed pierwszą czynnością %4, %5, %6 nT.</translation>
    </message>
    <message>
        <source>%1: %2, %3, %4 nT per ampere.</source>
        <translation>%1: %2, %3, %4 nT na amper.</translation>
    </message>
    <message>
        <source>signed %1 (names not verified)</source>
        <translation>podpisał %1 (nazwisk nie sprawdzono)</translation>
    </message>
    <message>
        <source>1.05 (Jacobs et al. 2014)</source>
        <translation>1.05 (Jacobs i in. 2014)</translation>
    </message>
    <message>
        <source>1.0530 (exact: straight lines between eight points hold the sine)</source>
        <translation>1.0530 (dokładnie: proste między ośmioma punktami oddają sinusoidę)</translation>
    </message>
    <message>
        <source>1 (none: the points lie on the curve)</source>
        <translation>1 (bez: punkty leżą na krzywej)</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Meldunki</translation>
    </message>
    <message>
        <source>%1, %2 used; %3</source>
        <translation>%1, użyto %2; %3</translation>
    </message>
    <message>
        <source>e = dir(Vg − wind reported) − dir(Vg − reference wind) = offset + in phase · sin + quadrature · cos of the heading read, weighted with airspeed squared; standard errors by flights (each left out in turn); winds after: each flight corrected by what the others tell</source>
        <translation>e = kier(Vg − wiatr meldowany) − kier(Vg − wiatr odniesienia) = przesunięcie + w fazie · sin + kwadratura · cos odczytanego kursu, ważone kwadratem prędkości powietrznej; błędy standardowe według lotów (każdy kolejno pominięty); wiatry po: każdy lot poprawiony według pozostałych</translation>
    </message>
    <message>
        <source>Table factor</source>
        <translation>Współczynnik tabeli</translation>
    </message>
    <message>
        <source>In common</source>
        <translation>Wspólne</translation>
    </message>
    <message>
        <source>%1 aircraft: in phase %2°, quadrature %3° — as a constant error of the reference wind of %4 kt would look</source>
        <translation>statków powietrznych %1: w fazie %2°, kwadratura %3° — tak wyglądałby stały błąd wiatru odniesienia %4 w</translation>
    </message>
    <message>
        <source>%1–%2°: %3</source>
        <translation>%1–%2°: %3</translation>
    </message>
    <message>
        <source>above %1°: %2</source>
        <translation>powyżej %1°: %2</translation>
    </message>
    <message>
        <source>By size of error</source>
        <translation>Według wielkości błędu</translation>
    </message>
    <message>
        <source>Out of line</source>
        <translation>Odstające</translation>
    </message>
    <message>
        <source>Indication error (read − true) of each aircraft</source>
        <translation>Błąd wskazania (odczytany − rzeczywisty) każdego statku powietrznego</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>Loty</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Użyto</translation>
    </message>
    <message>
        <source>In phase</source>
        <translation>W fazie</translation>
    </message>
    <message>
        <source>Quadr.</source>
        <translation>Kwadr.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Przesun.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>W poprzek</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Wzdłuż</translation>
    </message>
    <message>
        <source>Error of reported winds by source of heading</source>
        <translation>Błąd meldowanych wiatrów według źródła kursu</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupa</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Łącznie</translation>
    </message>
    <message>
        <source>held against: %1</source>
        <translation>porównano z: %1</translation>
    </message>
    <message>
        <source>Reported winds against each reference</source>
        <translation>Wiatry meldowane wobec każdego źródła odniesienia</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Źródła odniesienia</translation>
    </message>
    <message>
        <source>two of one report are %1 kt apart (rms)</source>
        <translation>dwa źródła jednego meldunku różnią się o %1 kt (rms)</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>Corrections to upload (deviation&apos;s sign, easterly positive)</source>
        <translation>Poprawki do wgrania (znak dewiacji, wschodnia dodatnia)</translation>
    </message>
    <message>
        <source>Deviation from winds</source>
        <translation>Dewiacja z wiatrów</translation>
    </message>
    <message>
        <source>Indication error = read − true heading; corrections and deviation (magnetic − compass, easterly positive) are its negative.</source>
        <translation>Błąd wskazania = kurs odczytany − rzeczywisty; poprawki i dewiacja (magnetyczny − kompasowy, wschodnia dodatnia) mają znak przeciwny.</translation>
    </message>
    <message>
        <source>What has to be said of each</source>
        <translation>Co o każdym trzeba powiedzieć</translation>
    </message>
    <message>
        <source>signed as %1</source>
        <translation>podpisał %1</translation>
    </message>
    <message>
        <source>other instrument</source>
        <translation>inny przyrząd</translation>
    </message>
    <message>
        <source>this PDF unpacks to more than %1 MiB; expected a report PDF of this program</source>
        <translation>ten PDF rozpakowuje się do ponad %1 MiB; oczekiwano sprawozdania PDF tego programu</translation>
    </message>
    <message>
        <source>is larger than %1 MiB; expected a report PDF of this program</source>
        <translation>jest większy niż %1 MiB; oczekiwano sprawozdania PDF tego programu</translation>
    </message>
    <message>
        <source>name not verified</source>
        <translation>nazwiska nie sprawdzono</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Dziennik zmian</translation>
    </message>
    <message>
        <source>head %1 after %2 entries</source>
        <translation>głowa %1 po %2 wpisach</translation>
    </message>
    <message>
        <source>%1, source: %2</source>
        <translation>%1, źródło: %2</translation>
    </message>
    <message>
        <source>* nobody read near</source>
        <translation>* nikt nie odczytał w pobliżu</translation>
    </message>
    <message>
        <source>Errors that all readings share (datum, variation) are not stated and not in them.</source>
        <translation>Błędów wspólnych wszystkim odczytom (wzorzec, deklinacja) nie podano i nie ma ich tutaj.</translation>
    </message>
    <message>
        <source>Good: the calibration can be used.</source>
        <translation>Dobra: kalibracji można użyć.</translation>
    </message>
    <message>
        <source>Doubtful.</source>
        <translation>Wątpliwa.</translation>
    </message>
    <message>
        <source>Not determined: this log does not tell the calibration.</source>
        <translation>Nieokreślona: z tego zapisu kalibracja nie wynika.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <source>Heading error, read − magnetic</source>
        <translation>Błąd kursu, odczytany − magnetyczny</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>The field&apos;s size spreads by %1 before and %2 after compensation (%3).</source>
        <translation>Wielkość pola rozrzuca się o %1 przed kompensacją i %2 po niej (%3).</translation>
    </message>
    <message>
        <source>Heading error, rms and largest: %1° and %2° before, %3° and %4° after.</source>
        <translation>Błąd kursu, średni kwadratowy i największy: %1° i %2° przed, %3° i %4° po.</translation>
    </message>
    <message>
        <source>By the uncertainty of the calibration a compensated heading is sure to %1° (95 %) or better in the cells below.</source>
        <translation>Przy niepewności kalibracji kurs skompensowany jest pewny do %1° (95 %) lub lepiej w komórkach poniżej.</translation>
    </message>
    <message>
        <source>by the field&apos;s size</source>
        <translation>według wielkości pola</translation>
    </message>
    <message>
        <source>against heading, pitch and roll</source>
        <translation>względem kursu, pochylenia i przechylenia</translation>
    </message>
    <message>
        <source>Calibration of a magnetometer</source>
        <translation>Kalibracja magnetometru</translation>
    </message>
    <message>
        <source>Because: </source>
        <translation>Ponieważ: </translation>
    </message>
    <message>
        <source>Next: </source>
        <translation>Dalej: </translation>
    </message>
    <message>
        <source>%1 samples, %2 used, %3; figures in %4 (%5).</source>
        <translation>próbek %1, użyto %2, %3; liczby w %4 (%5).</translation>
    </message>
    <message>
        <source>Not told: </source>
        <translation>Nieokreślone: </translation>
    </message>
    <message>
        <source>Log of a magnetometer, compensated</source>
        <translation>Zapis magnetometru, skompensowany</translation>
    </message>
    <message>
        <source>A helmet system asks: %1 %2 %3 %4: %5.</source>
        <translation>System hełmowy wymaga: %1 %2 %3 %4: %5.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nieznany</translation>
    </message>
    <message>
        <source>%1, met</source>
        <translation>%1, spełnione</translation>
    </message>
    <message>
        <source>%1, NOT MET</source>
        <translation>%1, NIESPEŁNIONE</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>nie sprawdzono</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>zachowana</translation>
    </message>
    <message>
        <source>TOO NEAR by %1 m</source>
        <translation>ZA BLISKO o %1 m</translation>
    </message>
    <message>
        <source>▲ %1 of %2 distances are too small; %3 were looked at.</source>
        <translation>▲ %1 z %2 odległości jest za małych; sprawdzono %3.</translation>
    </message>
    <message>
        <source>● All %1 distances are kept.</source>
        <translation>● Wszystkie odległości (%1) są zachowane.</translation>
    </message>
    <message>
        <source>○ %1 of %2 distances were looked at; none is too small.</source>
        <translation>○ Sprawdzono %1 z %2 odległości; żadna nie jest za mała.</translation>
    </message>
    <message>
        <source>Installation of a flux gate</source>
        <translation>Zabudowa czujnika indukcyjnego</translation>
    </message>
    <message>
        <source>Least distances as the maker of a flux gate asks (Garmin, installation manual of the GMU 11/44).</source>
        <translation>Najmniejsze odległości, jakich żąda producent czujnika (Garmin, instrukcja zabudowy GMU 11/44).</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Odległości</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Co najmniej</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzono</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Przyczyny</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Przyczyna</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azymut</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elewacja</translation>
    </message>
    <message>
        <source>turret</source>
        <translation>wieżyczka</translation>
    </message>
    <message>
        <source>1 sigma</source>
        <translation>1 sigma</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>stałe</translation>
    </message>
    <message>
        <source>all that stays</source>
        <translation>wszystko, co stałe</translation>
    </message>
    <message>
        <source>all by chance</source>
        <translation>wszystko, co przypadkowe</translation>
    </message>
    <message>
        <source>together</source>
        <translation>razem</translation>
    </message>
    <message>
        <source>root of squares</source>
        <translation>pierwiastek z kwadratów</translation>
    </message>
    <message>
        <source>Looking at azimuth %1°, elevation %2° in the aircraft (helmet: heading %3°, pitch %4°, roll %5°), that is %6°, %7° for the turret: off by %8° in azimuth and %9° in elevation there.</source>
        <translation>Patrząc na azymut %1°, elewację %2° w statku powietrznym (hełm: kurs %3°, pochylenie %4°, przechylenie %5°), czyli %6°, %7° dla wieżyczki: odchyłka tam %8° w azymucie i %9° w elewacji.</translation>
    </message>
    <message>
        <source>Line of sight of a helmet</source>
        <translation>Linia wzroku hełmu</translation>
    </message>
    <message>
        <source>Field %1 nT, dip %2°; aircraft: heading %3°, pitch %4°, roll %5°. Noise of an axis %6 nT (aircraft) and %7 nT (helmet); pitch and roll sure to %8° and %9°.</source>
        <translation>Pole %1 nT, inklinacja %2°; statek powietrzny: kurs %3°, pochylenie %4°, przechylenie %5°. Szum osi %6 nT (statek) i %7 nT (hełm); pochylenie i przechylenie pewne do %8° i %9°.</translation>
    </message>
    <message>
        <source>Turret: mount roll %1°, pitch %2°, yaw %3°, each sure to %4°. Field of the cockpit %5, %6, %7 nT.</source>
        <translation>Wieżyczka: przechylenie mocowania %1°, pochylenie %2°, odchylenie %3°, każde pewne do %4°. Pole kabiny %5, %6, %7 nT.</translation>
    </message>
    <message>
        <source>%1° on %2 magnetic</source>
        <translation>%1° na kursie magnetycznym %2</translation>
    </message>
    <message>
        <source>Error of reported winds by altitude, before and after the correction</source>
        <translation>Błąd podawanych wiatrów według wysokości, przed poprawką i po niej</translation>
    </message>
    <message>
        <source>Source of a stray field</source>
        <translation>Źródło pola rozproszonego</translation>
    </message>
    <message>
        <source>One dipole and a uniform field, by least squares from %1 readings; %2 nT rms of a component are left. The nearest reading stands %3 m from the source; standard errors are one sigma.</source>
        <translation>Jeden dipol i pole jednorodne, metodą najmniejszych kwadratów z %1 odczytów; pozostaje %2 nT (wartość skuteczna składowej). Najbliższy odczyt leży %3 m od źródła; błędy standardowe to jedna sigma.</translation>
    </message>
    <message>
        <source>place (m)</source>
        <translation>miejsce (m)</translation>
    </message>
    <message>
        <source>its standard error (m)</source>
        <translation>jego błąd standardowy (m)</translation>
    </message>
    <message>
        <source>moment (A m²)</source>
        <translation>moment (A m²)</translation>
    </message>
    <message>
        <source>uniform field (nT)</source>
        <translation>pole jednorodne (nT)</translation>
    </message>
    <message>
        <source>Size of the moment: %1 ± %2 A m² (one standard error).</source>
        <translation>Wielkość momentu: %1 ± %2 A m² (błąd standardowy).</translation>
    </message>
    <message>
        <source>Site check</source>
        <translation>Sprawdzenie miejsca</translation>
    </message>
    <message>
        <source>A run clockwise held against one counter-clockwise: what differs is no deviation.</source>
        <translation>Obrót w prawo porównany z obrotem w lewo: to, co się różni, nie jest dewiacją.</translation>
    </message>
    <message>
        <source>● The largest difference, %1°, is within %2°.</source>
        <translation>● Największa różnica, %1°, mieści się w %2°.</translation>
    </message>
    <message>
        <source>▲ The largest difference, %1°, is MORE THAN %2°.</source>
        <translation>▲ Największa różnica, %1°, to WIĘCEJ NIŻ %2°.</translation>
    </message>
    <message>
        <source>%1° rms are left.</source>
        <translation>Pozostaje %1° (wartość skuteczna).</translation>
    </message>
    <message>
        <source>Clockwise − counter-clockwise</source>
        <translation>W prawo − w lewo</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Różnica</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>stała</translation>
    </message>
    <message>
        <source>with sin of heading</source>
        <translation>z sinusem kursu</translation>
    </message>
    <message>
        <source>with cos of heading</source>
        <translation>z cosinusem kursu</translation>
    </message>
    <message>
        <source>Distribution of the coefficients (line: mean; named: far from the others); amplitudes by order</source>
        <translation>Rozkład współczynników (linia: średnia; z nazwą: daleko od pozostałych); amplitudy według rzędu</translation>
    </message>
    <message>
        <source>A lies</source>
        <translation>A leży</translation>
    </message>
    <message>
        <source>average</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>farthest</source>
        <translation>najdalej</translation>
    </message>
    <message>
        <source>east of the usual</source>
        <translation>na wschód od zwykłego</translation>
    </message>
    <message>
        <source>west of the usual</source>
        <translation>na zachód od zwykłego</translation>
    </message>
    <message>
        <source>%1; then it was swung otherwise: %2</source>
        <translation>%1; potem wykonano dewiację inaczej: %2</translation>
    </message>
    <message>
        <source>compass</source>
        <comment>heading</comment>
        <translation>kurs kompasowy</translation>
    </message>
    <message>
        <source>Compass</source>
        <comment>heading</comment>
        <translation>Kurs kompasowy</translation>
    </message>
    <message>
        <source>sin δ = Σ g (S b + p/H): the sensor&apos;s soft and hard iron followed by a Kalman filter at every attitude; a scale that all axes share turns no heading, so k is 0. Figures are degrees: soft iron times 57.3, P, Q and R over H. A to E are level where the last update was.</source>
        <translation>sin δ = Σ g (S b + p/H): żelazo miękkie i twarde czujnika śledzone filtrem Kalmana w każdym położeniu; wspólna skala wszystkich osi nie zmienia kursu, więc k wynosi 0. Wartości w stopniach: żelazo miękkie razy 57,3, P, Q i R przez H. Od A do E w locie poziomym tam, gdzie była ostatnia aktualizacja.</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Przesunięcie</translation>
    </message>
    <message>
        <source>Kept benches</source>
        <translation>Przechowywane pomiary</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numer seryjny</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Zakres</translation>
    </message>
    <message>
        <source>Noise, largest</source>
        <translation>Szum, największy</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Zapis</translation>
    </message>
    <message>
        <source>The benches of %1 and %2 %3.</source>
        <translation>Pomiary na stanowisku z %1 i %2 %3.</translation>
    </message>
    <message>
        <source>From %1 to %2 on x, y, z (95 %): bias %3 nT a year; scale %4 millionths a year; noise %5 times what it was.</source>
        <translation>Od %1 do %2 na x, y, z (95 %): przesunięcie %3 nT na rok; skala %4 milionowych na rok; szum %5 razy taki jak przedtem.</translation>
    </message>
    <message>
        <source>ψ′ is the compass heading</source>
        <translation>ψ′ to kurs busoli</translation>
    </message>
    <message>
        <source>ψ′ is the compass heading with its index of %1°</source>
        <translation>ψ′ to kurs busoli z jej indeksem %1°</translation>
    </message>
    <message>
        <source>least squares of δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′; %1, A to E are angles. Residual = deviation read − deviation fitted.</source>
        <translation>najmniejsze kwadraty dla δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′; %1, A do E są kątami. Reszta = dewiacja odczytana − dewiacja dopasowana.</translation>
    </message>
    <message>
        <source>OUT AS A WHOLE: LOOK AT ITS MOUNT</source>
        <translation>W CAŁOŚCI PRZESUNIĘTA: SPRAWDŹ MOCOWANIE</translation>
    </message>
    <message>
        <source>%1: OUT AS A WHOLE, LOOK AT ITS MOUNT</source>
        <translation>%1: W CAŁOŚCI PRZESUNIĘTA, SPRAWDŹ MOCOWANIE</translation>
    </message>
    <message>
        <source>Not signed: the record says signed, and nobody&apos;s signature is there</source>
        <translation>Niepodpisane: zapis mówi, że podpisano, a niczyjego podpisu nie ma</translation>
    </message>
    <message>
        <source>this PDF is damaged: its data do not fit their check sum; expected the report as it was written</source>
        <translation>ten plik PDF jest uszkodzony: dane nie zgadzają się z sumą kontrolną; oczekiwano sprawozdania w postaci, w jakiej je zapisano</translation>
    </message>
    <message>
        <source>signed by its state alone: NO SIGNATURE STANDS</source>
        <translation>podpisany tylko według stanu: ŻADEN PODPIS NIE STOI</translation>
    </message>
    <message>
        <source>bias at %1 °C (nT)</source>
        <translation>przesunięcie przy %1 °C (nT)</translation>
    </message>
    <message>
        <source>Both biases are taken at %1 °C.</source>
        <translation>Oba przesunięcia przyjęto przy %1 °C.</translation>
    </message>
    <message numerus="yes">
        <source>largest error %1° with %2° selected, mean %3°, of %n heading(s)</source>
        <translation>
            <numerusform>największy błąd %1° przy nastawionych %2°, średnio %3°, z %n kursu</numerusform>
            <numerusform>największy błąd %1° przy nastawionych %2°, średnio %3°, z %n kursów</numerusform>
            <numerusform>największy błąd %1° przy nastawionych %2°, średnio %3°, z %n kursów</numerusform>
        </translation>
    </message>
    <message>
        <source>NOT KNOWN</source>
        <translation>NIE WIADOMO</translation>
    </message>
    <message>
        <source>Errors that all readings share are in them (%1, in degrees), and in the intervals with 1.96 of theirs: they are stated, not estimated from the scatter.</source>
        <translation>Błędy wspólne dla wszystkich odczytów są w nich zawarte (%1, w stopniach), a w przedziałach z czynnikiem 1,96: są podane, nie oszacowane z rozrzutu.</translation>
    </message>
    <message>
        <source>▲ It does not pass: the runs are not one each way round over all headings.</source>
        <translation>▲ Nie przechodzi: przebiegi nie są po jednym w każdą stronę po wszystkich kursach.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DueBadge</name>
    <message>
        <source>overdue</source>
        <translation>po terminie</translation>
    </message>
    <message>
        <source>due</source>
        <translation>wymagany</translation>
    </message>
    <message>
        <source>due soon</source>
        <translation>wkrótce wymagany</translation>
    </message>
    <message>
        <source>not due</source>
        <translation>niewymagany</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DuePage</name>
    <message>
        <source>&amp;Waive</source>
        <translation>&amp;Odstąp</translation>
    </message>
    <message>
        <source>&amp;Open the compass</source>
        <translation>Ot&amp;wórz busolę</translation>
    </message>
    <message>
        <source>What is due</source>
        <translation>Do wykonania</translation>
    </message>
    <message>
        <source>Calendar rules</source>
        <translation>Reguły kalendarzowe</translation>
    </message>
    <message>
        <source>due now</source>
        <translation>do wykonania teraz</translation>
    </message>
    <message>
        <source>due now or soon</source>
        <translation>do wykonania teraz lub wkrótce</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>wszystko</translation>
    </message>
    <message>
        <source>aircraft, compass or reason</source>
        <translation>statek powietrzny, busola lub powód</translation>
    </message>
    <message>
        <source>Write a &amp;calendar (.ics)…</source>
        <translation>Zapisz &amp;kalendarz (.ics)…</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Busola</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>Last signed</source>
        <translation>Ostatnio podpisana</translation>
    </message>
    <message>
        <source>By calendar</source>
        <translation>Według kalendarza</translation>
    </message>
    <message>
        <source>why no swing is needed, as: two headings 90° apart show no change</source>
        <translation>dlaczego pomiar nie jest potrzebny, np.: dwa kursy odległe o 90° nie wykazują zmiany</translation>
    </message>
    <message>
        <source>who answers for it</source>
        <translation>kto za to odpowiada</translation>
    </message>
    <message>
        <source>A waiver is kept for ever and answers this one event</source>
        <translation>Odstąpienie pozostaje na zawsze i dotyczy tego jednego zdarzenia</translation>
    </message>
    <message>
        <source>Its page, where swings are begun and events recorded</source>
        <translation>Jej strona, gdzie rozpoczyna się pomiary i zapisuje zdarzenia</translation>
    </message>
    <message>
        <source>all types</source>
        <translation>wszystkie typy</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>%1 of %2 compasses, on %3</source>
        <translation>busol: %1 z %2, dnia %3</translation>
    </message>
    <message>
        <source>. No calendar rule is set: see the second tab.</source>
        <translation>. Nie ustawiono reguły kalendarzowej: zob. drugą kartę.</translation>
    </message>
    <message>
        <source>. Not predicted after a move: %1</source>
        <translation>. Bez prognozy po przebazowaniu: %1</translation>
    </message>
    <message>
        <source>Only an event is waived; a calendar rule or a move is answered by a swing.</source>
        <translation>Odstąpić można tylko od zdarzenia; na regułę kalendarzową i przebazowanie odpowiada pomiar.</translation>
    </message>
    <message>
        <source>A waiver is kept for ever: state why no swing is needed, and who answers for it.</source>
        <translation>Odstąpienie pozostaje na zawsze: podaj, dlaczego pomiar nie jest potrzebny i kto za to odpowiada.</translation>
    </message>
    <message>
        <source>Write a calendar</source>
        <translation>Zapisywanie kalendarza</translation>
    </message>
    <message>
        <source>Calendar (*.ics)</source>
        <translation>Kalendarz (*.ics)</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n dates</source>
        <translation>
            <numerusform>%1: %n termin</numerusform>
            <numerusform>%1: %n terminy</numerusform>
            <numerusform>%1: %n terminów</numerusform>
        </translation>
    </message>
    <message>
        <source>What is &amp;due</source>
        <translation>&amp;Do wykonania</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Write the &amp;calendar (.ics)…</source>
        <translation>Zapisz &amp;kalendarz (.ics)…</translation>
    </message>
    <message>
        <source>. What the fleet&apos;s history expects is being computed.</source>
        <translation>. Trwa obliczanie, czego oczekiwać po historii floty.</translation>
    </message>
    <message>
        <source>What calls for a swing, and since when: by the calendar rules, by an event such as a lightning strike, by a move, or because the fleet&apos;s history expects it out of limits before its next date (due from a chance of one half on, due soon from one fifth on). Enter opens the compass. An event that needs no swing is waived, with a reason and a name that stay on the record.</source>
        <translation>Co wymaga pomiaru i od kiedy: reguły kalendarzowe, zdarzenie takie jak uderzenie pioruna, przeniesienie albo to, że według historii floty przed następnym terminem wyjdzie poza granice (pomiar należny od szansy jednej drugiej, wkrótce od jednej piątej). Enter otwiera busolę. Od zdarzenia, które nie wymaga pomiaru, odstępuje się z powodem i nazwiskiem, które zostają w zapisie.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::DueRulesTable</name>
    <message>
        <source>all</source>
        <translation>wszystkie</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not allowed for %2; expected a whole number from %3 on</source>
        <translation>„%1” jest niedozwolone dla: %2; oczekiwano liczby całkowitej od %3</translation>
    </message>
    <message>
        <source>&amp;Remove the rule</source>
        <translation>&amp;Usuń regułę</translation>
    </message>
    <message>
        <source>Take over &amp;known rules</source>
        <translation>Przejmij &amp;znane reguły</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Reguła</translation>
    </message>
    <message>
        <source>Months</source>
        <translation>Miesiące</translation>
    </message>
    <message>
        <source>Grace (days)</source>
        <translation>Zwłoka (dni)</translation>
    </message>
    <message>
        <source>Warn (days)</source>
        <translation>Ostrzeżenie (dni)</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Issue</source>
        <translation>Wydanie</translation>
    </message>
    <message>
        <source>Aircraft type</source>
        <translation>Typ statku powietrznego</translation>
    </message>
    <message>
        <source>24 months (CASA) and 12 months (South Africa): the only calendar rules whose source could be read</source>
        <translation>24 miesiące (CASA) i 12 miesięcy (RPA): jedyne reguły kalendarzowe, których źródło można było przeczytać</translation>
    </message>
    <message>
        <source>a type without compasses</source>
        <translation>typ bez busol</translation>
    </message>
    <message>
        <source>Type a name to make a new rule</source>
        <translation>Wpisz nazwę, aby utworzyć nową regułę</translation>
    </message>
    <message>
        <source>months</source>
        <translation>miesiące</translation>
    </message>
    <message>
        <source>days of grace</source>
        <translation>dni zwłoki</translation>
    </message>
    <message>
        <source>days of warning</source>
        <translation>dni ostrzeżenia</translation>
    </message>
    <message>
        <source>there is no aircraft type %1; expected one of the fleet, or all</source>
        <translation>nie ma typu %1; oczekiwano typu z floty albo: wszystkie</translation>
    </message>
    <message>
        <source>change of the rule %1</source>
        <translation>zmiana reguły %1</translation>
    </message>
    <message>
        <source>new rule</source>
        <translation>nowa reguła</translation>
    </message>
    <message>
        <source>removal of the rule %1</source>
        <translation>usunięcie reguły %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::EarthFieldPage</name>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 do %3</translation>
    </message>
    <message>
        <source>51.55 N</source>
        <translation>51.55 N</translation>
    </message>
    <message>
        <source>21.89 E</source>
        <translation>21.89 E</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>year-month-day, or 2026.5</source>
        <translation>rok-miesiąc-dzień albo 2026.5</translation>
    </message>
    <message>
        <source>Ma&amp;p of:</source>
        <translation>&amp;Mapa:</translation>
    </message>
    <message>
        <source>WMM in its years, else IGRF</source>
        <translation>WMM w jego latach, poza tym IGRF</translation>
    </message>
    <message>
        <source>From a file …</source>
        <translation>Z pliku …</translation>
    </message>
    <message>
        <source>Coefficient files: WMM and WMMHR (.COF), tables of the IGRF</source>
        <translation>Pliki współczynników: WMM i WMMHR (.COF), tablice IGRF</translation>
    </message>
    <message>
        <source>&amp;Site:</source>
        <translation>M&amp;iejsce:</translation>
    </message>
    <message>
        <source>&amp;Latitude:</source>
        <translation>&amp;Szerokość geogr.:</translation>
    </message>
    <message>
        <source>L&amp;ongitude:</source>
        <translation>&amp;Długość geogr.:</translation>
    </message>
    <message>
        <source>&amp;Height (m):</source>
        <translation>&amp;Wysokość (m):</translation>
    </message>
    <message>
        <source>&amp;Date (UTC):</source>
        <translation>D&amp;ata (UTC):</translation>
    </message>
    <message>
        <source>&amp;Model:</source>
        <translation>&amp;Model:</translation>
    </message>
    <message>
        <source>Above the WGS84 ellipsoid; a height above the sea will do</source>
        <translation>Nad elipsoidą WGS84; wysokość nad poziomem morza wystarczy</translation>
    </message>
    <message>
        <source>Earth&apos;s field</source>
        <translation>pole Ziemi</translation>
    </message>
    <message>
        <source>as typed below</source>
        <translation>jak wpisano niżej</translation>
    </message>
    <message>
        <source>Coefficients of the Earth&apos;s field</source>
        <translation>Współczynniki pola Ziemi</translation>
    </message>
    <message>
        <source>Coefficients (*.COF *.cof *.txt);;All files (*)</source>
        <translation>Współczynniki (*.COF *.cof *.txt);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Pick a site, or type latitude and longitude.</source>
        <translation>Wybierz miejsce albo wpisz szerokość i długość geograficzną.</translation>
    </message>
    <message>
        <source>&amp;Earth&apos;s field</source>
        <translation>Pole Pole Pole &amp;ziemskieZiemiamp;ziemskie</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>The Earth&apos;s field at a site or any place, on a day: variation, dip and strength, how sure the model is, and how a compass can be used there. The map shows one element over the whole world, with the place on it.</source>
        <translation>Pole Ziemi w miejscu dewiacji lub gdziekolwiek, w danym dniu: deklinacja, inklinacja i natężenie, pewność modelu oraz przydatność busoli. Mapa pokazuje jeden element na całym świecie z zaznaczonym miejscem.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ElectricalPage</name>
    <message>
        <source>&apos;%1&apos; is not allowed; expected a number from −%2 to %2</source>
        <translation>„%1” jest niedozwolone; oczekiwano liczby od −%2 do %2</translation>
    </message>
    <message>
        <source>&amp;New electrical swing</source>
        <translation>&amp;Nowy pomiar elektryczny</translation>
    </message>
    <message>
        <source>As a &amp;swing</source>
        <translation>Jako p&amp;omiar</translation>
    </message>
    <message>
        <source>before</source>
        <translation>przedtem</translation>
    </message>
    <message>
        <source>error</source>
        <translation>błąd</translation>
    </message>
    <message>
        <source>after</source>
        <translation>po</translation>
    </message>
    <message>
        <source>indicated</source>
        <translation>wskazany</translation>
    </message>
    <message>
        <source>by turntable</source>
        <translation>ze stołu obrotowego</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Data:</translation>
    </message>
    <message>
        <source>North–south line:</source>
        <translation>Linia północ–południe:</translation>
    </message>
    <message>
        <source>Calibrator:</source>
        <translation>Kalibrator:</translation>
    </message>
    <message>
        <source>Its serial number:</source>
        <translation>Jego numer seryjny:</translation>
    </message>
    <message>
        <source>Sensor sheet:</source>
        <translation>Karta czujnika:</translation>
    </message>
    <message>
        <source>E1 normal (V):</source>
        <translation>E1 normalnie (V):</translation>
    </message>
    <message>
        <source>E1 reversed (V):</source>
        <translation>E1 odwrotnie (V):</translation>
    </message>
    <message>
        <source>E2 normal (V):</source>
        <translation>E2 normalnie (V):</translation>
    </message>
    <message>
        <source>E2 reversed (V):</source>
        <translation>E2 odwrotnie (V):</translation>
    </message>
    <message>
        <source>MISAL (°):</source>
        <translation>MISAL (°):</translation>
    </message>
    <message>
        <source>δ180 (°):</source>
        <translation>δ180 (°):</translation>
    </message>
    <message>
        <source>δ270 (°):</source>
        <translation>δ270 (°):</translation>
    </message>
    <message>
        <source>By:</source>
        <translation>Według:</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <source>Table F1 (error = indicated − selected; deviation is its negative):</source>
        <translation>Tabela F1 (błąd = wskazany − nastawiony; dewiacja ma znak przeciwny):</translation>
    </message>
    <message>
        <source>Electrical swings · %1 · %2</source>
        <translation>Pomiary elektryczne · %1 · %2</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>%1: N–S %2°, E–W %3°, index %4°; pairs 0/180 %5°, 90/270 %6°: %7</source>
        <translation>%1: N–S %2°, E–W %3°, indeks %4°; pary 0/180 %5°, 90/270 %6°: %7</translation>
    </message>
    <message>
        <source>agree within 0.2° (TM 11-4920-292-15)</source>
        <translation>zgodne w granicach 0,2° (TM 11-4920-292-15)</translation>
    </message>
    <message>
        <source>do NOT agree within 0.2° (TM 11-4920-292-15)</source>
        <translation>NIEzgodne w granicach 0,2° (TM 11-4920-292-15)</translation>
    </message>
    <message>
        <source>E1 mean %1 V</source>
        <translation>E1 średnio %1 V</translation>
    </message>
    <message>
        <source>E2 mean %1 V</source>
        <translation>E2 średnio %1 V</translation>
    </message>
    <message>
        <source>Set self-check: largest %1′, mean %2′: %3</source>
        <translation>Samosprawdzenie zestawu: największy %1′, średni %2′: %3</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>zaliczone</translation>
    </message>
    <message>
        <source>NOT passed</source>
        <translation>NIEzaliczone</translation>
    </message>
    <message>
        <source>open: %1</source>
        <translation>otwarte: %1</translation>
    </message>
    <message>
        <source>electrical swing of %1</source>
        <translation>pomiar elektryczny z %1</translation>
    </message>
    <message>
        <source>new electrical swing</source>
        <translation>nowy pomiar elektryczny</translation>
    </message>
    <message>
        <source>&amp;Electrical swings of this compass</source>
        <translation>Pomiary &amp;elektryczne tej busoli</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>select %1, turn %2: %3 → %4</source>
        <translation>wybierz %1, obróć %2: %3 → %4</translation>
    </message>
    <message>
        <source>half of the error out with N–S</source>
        <translation>połowę błędu usunąć przez N–S</translation>
    </message>
    <message>
        <source>all of it out with E–W</source>
        <translation>cały błąd usunąć przez E–W</translation>
    </message>
    <message>
        <source>half of it out with E–W</source>
        <translation>połowę błędu usunąć przez E–W</translation>
    </message>
    <message>
        <source>Write the &amp;record…</source>
        <translation>Zapisz &amp;protokół…</translation>
    </message>
    <message>
        <source>%1 electrical swing %2</source>
        <translation>%1 pomiar elektryczny %2</translation>
    </message>
    <message>
        <source>Write the record of the electrical swing</source>
        <translation>Zapisywanie protokołu pomiaru elektrycznego</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Record written: %1</source>
        <translation>Zapisano protokół: %1</translation>
    </message>
    <message>
        <source>Electrical swings</source>
        <translation>Pomiary elektryczne</translation>
    </message>
    <message>
        <source>There is no electrical swing of this compass yet: begin one first.</source>
        <translation>Tej busoli nie mierzono jeszcze elektrycznie: najpierw rozpocznij pomiar.</translation>
    </message>
    <message>
        <source>The data sheet of an electrical swing: type what the compass indicates at each selected heading; the errors, what to turn and the verdict follow. Errors on this sheet are indicated − selected, the negative of the deviation elsewhere in the program.</source>
        <translation>Karta pomiaru elektrycznego: wpisz wskazanie busoli na każdym nastawionym kursie; błędy, elementy do obrócenia i ocena wynikną same. Błędy na tej karcie to wskazany − nastawiony, czyli dewiacja ze znakiem przeciwnym.</translation>
    </message>
    <message>
        <source>No electrical swing of this compass is on record: “New electrical swing” begins one.</source>
        <translation>W zapisach nie ma pomiaru elektrycznego tej busoli: zaczyna go „Nowy pomiar elektryczny”.</translation>
    </message>
    <message numerus="yes">
        <source>Headings: largest error %1° with %2° selected, mean %3°, of %n heading(s)</source>
        <translation>
            <numerusform>Kursy: największy błąd %1° przy nastawionych %2°, średnio %3°, z %n kursu</numerusform>
            <numerusform>Kursy: największy błąd %1° przy nastawionych %2°, średnio %3°, z %n kursów</numerusform>
            <numerusform>Kursy: największy błąd %1° przy nastawionych %2°, średnio %3°, z %n kursów</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”, typed with %2° selected, is not stored: look at the table as it is now, and type it again.</source>
        <translation>„%1”, wpisane przy nastawionych %2°, nie jest zapisane: obejrzeć tablicę w obecnym stanie i wpisać ponownie.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ErrorMapWords</name>
    <message>
        <source>magnetic heading (°)</source>
        <translation>kurs magnetyczny (°)</translation>
    </message>
    <message>
        <source>pitch (°)</source>
        <translation>pochylenie (°)</translation>
    </message>
    <message>
        <source>after: up to %1°</source>
        <translation>po: do %1°</translation>
    </message>
    <message>
        <source>heading %1°, pitch %2°: deviation %3° before</source>
        <translation>kurs %1°, pochylenie %2°: dewiacja %3° przed</translation>
    </message>
    <message>
        <source>, %1° after</source>
        <translation>, %1° po</translation>
    </message>
    <message>
        <source>, sure to %1° (95 %)</source>
        <translation>, pewna do %1° (95 %)</translation>
    </message>
    <message>
        <source>; %1 samples</source>
        <translation>; próbek %1</translation>
    </message>
    <message>
        <source>No headings: nothing is compensated yet.</source>
        <translation>Brak kursów: niczego jeszcze nie skompensowano.</translation>
    </message>
    <message>
        <source>before: up to %1° (west blue, east red, to this size in both; hatched: no samples)</source>
        <translation>przed: do %1° (zachód niebieski, wschód czerwony, do tej wielkości na obu; kreskowane: brak próbek)</translation>
    </message>
    <message>
        <source>heading %1°, pitch %2°: no samples</source>
        <translation>kurs %1°, pochylenie %2°: brak próbek</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::EventsPanel</name>
    <message>
        <source>Add event</source>
        <translation>Dodaj zdarzenie</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Zdarzenia</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Zdarzenie</translation>
    </message>
    <message>
        <source>Makes a swing due</source>
        <translation>Wymaga pomiaru dewiacji</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>year-month-day</source>
        <translation>rok-miesiąc-dzień</translation>
    </message>
    <message>
        <source>lightning strike, engine change, hard landing …</source>
        <translation>uderzenie pioruna, wymiana silnika, twarde lądowanie …</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Data:</translation>
    </message>
    <message>
        <source>Event:</source>
        <translation>Zdarzenie:</translation>
    </message>
    <message>
        <source>Makes due:</source>
        <translation>Wymaga pomiaru:</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <source>Say what happened, as “lightning strike”.</source>
        <translation>Podaj, co się stało, na przykład „uderzenie pioruna”.</translation>
    </message>
    <message>
        <source>event of %1</source>
        <translation>zdarzenie z %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ExclusionPanel</name>
    <message>
        <source>E&amp;xclude</source>
        <translation>&amp;Pomiń</translation>
    </message>
    <message>
        <source>the reason stays on the record</source>
        <translation>powód pozostaje w zapisie</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Why is the reading on %1 left out?</source>
        <translation>Dlaczego odczyt na kursie %1 jest pominięty?</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FieldStampPanel</name>
    <message>
        <source>Earth&apos;s field: H %1 nT · dip %2 · variation %3 · %4 for %5</source>
        <translation>Pole Ziemi: H %1 nT · inklinacja %2 · deklinacja %3 · %4 dla %5</translation>
    </message>
    <message>
        <source>Earth&apos;s field: not kept with this swing.</source>
        <translation>Pole Ziemi: nie zapisano przy tym pomiarze.</translation>
    </message>
    <message>
        <source>X %1, Y %2, Z %3 nT at %4, %5, %6 m</source>
        <translation>X %1, Y %2, Z %3 nT w punkcie %4, %5, %6 m</translation>
    </message>
    <message>
        <source>&amp;Take the new values</source>
        <translation>&amp;Przyjmij nowe wartości</translation>
    </message>
    <message>
        <source>&amp;Keep the field of site and date</source>
        <translation>&amp;Zapisz pole miejsca i daty</translation>
    </message>
    <message>
        <source>H %1 nT · dip %2 · variation %3</source>
        <translation>H %1 nT · inklinacja %2 · deklinacja %3</translation>
    </message>
    <message>
        <source>Site or date have changed since: there it is %1.</source>
        <translation>Od tego czasu zmieniono miejsce lub datę: tam wynosi ono %1.</translation>
    </message>
    <message>
        <source>By %1 it is now %2.</source>
        <translation>Według %1 wynosi ono teraz %2.</translation>
    </message>
    <message>
        <source>The variation stated, %1, differs by %2 from the field&apos;s: look at variation, site and date again.</source>
        <translation>Podana deklinacja, %1, różni się o %2 od deklinacji pola: sprawdź ponownie deklinację, miejsce i datę.</translation>
    </message>
    <message>
        <source>Earth&apos;s field</source>
        <translation>pole Ziemi</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FieldText</name>
    <message>
        <source>“%1” is no size of a division; expected degrees above 0 and up to 90, as 0.5</source>
        <translation>„%1” nie jest wielkością działki; oczekiwano stopni powyżej 0, najwyżej 90, na przykład 0.5</translation>
    </message>
    <message>
        <source>“%1” is no year; expected four digits, as 1984</source>
        <translation>„%1” nie jest rokiem; oczekiwano czterech cyfr, na przykład 1984</translation>
    </message>
    <message>
        <source>“%1” is no date; expected year-month-day or day.month.year, as 2026-11-20 or 20.11.2026</source>
        <translation>„%1” nie jest datą; oczekiwano rok-miesiąc-dzień albo dzień.miesiąc.rok, jak 2026-11-20 albo 20.11.2026</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FieldValues</name>
    <message>
        <source>Elements of the Earth&apos;s field</source>
        <translation>Elementy pola Ziemi</translation>
    </message>
    <message>
        <source>value</source>
        <translation>wartość</translation>
    </message>
    <message>
        <source>a year</source>
        <translation>rocznie</translation>
    </message>
    <message>
        <source>± 1 σ</source>
        <translation>± 1 σ</translation>
    </message>
    <message>
        <source>X north (nT)</source>
        <translation>X północ (nT)</translation>
    </message>
    <message>
        <source>Y east (nT)</source>
        <translation>Y wschód (nT)</translation>
    </message>
    <message>
        <source>Z down (nT)</source>
        <translation>Z w dół (nT)</translation>
    </message>
    <message>
        <source>H horizontal (nT)</source>
        <translation>H poziome (nT)</translation>
    </message>
    <message>
        <source>F total (nT)</source>
        <translation>F całkowite (nT)</translation>
    </message>
    <message>
        <source>D east + (°)</source>
        <translation>D wschodnia + (°)</translation>
    </message>
    <message>
        <source>I down + (°)</source>
        <translation>I w dół + (°)</translation>
    </message>
    <message>
        <source>This model states no uncertainty</source>
        <translation>Ten model nie podaje niepewności</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FleetDrawing</name>
    <message>
        <source>Nothing to draw: no swing of the selection tells a deviation here.</source>
        <translation>Nie ma czego narysować: żaden wybrany pomiar nie mówi tu o dewiacji.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>± 1 sd between aircraft</source>
        <translation>± 1 odch. std. między statkami powietrznymi</translation>
    </message>
    <message>
        <source>5 and 95 %</source>
        <translation>5 i 95 %</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>granica</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>stan zastany</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>stan końcowy</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FleetModel</name>
    <message>
        <source>no date</source>
        <translation>brak daty</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>, rev. %1</source>
        <translation>, wyd. %1</translation>
    </message>
    <message>
        <source>, amended</source>
        <translation>, zmieniony</translation>
    </message>
    <message>
        <source>, guided, in work</source>
        <translation>, prowadzony, w toku</translation>
    </message>
    <message>
        <source> · largest deviation %1°</source>
        <translation> · największa dewiacja %1°</translation>
    </message>
    <message>
        <source>%1 · %2 %3</source>
        <translation>%1 · %2 %3</translation>
    </message>
    <message>
        <source>aircraft: %1</source>
        <translation>statki powietrzne: %1</translation>
    </message>
    <message>
        <source>demonstration data: invented</source>
        <translation>dane pokazowe: zmyślone</translation>
    </message>
    <message>
        <source>swings: %1</source>
        <translation>pomiary: %1</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>szkic</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Flota</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>%1 · readings: %2</source>
        <translation>%1 · odczytów: %2</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>uszkodzony</translation>
    </message>
    <message>
        <source>, guided, abandoned</source>
        <translation>, prowadzony, przerwany</translation>
    </message>
    <message>
        <source>, guided, at %1</source>
        <translation>, prowadzony, na %1</translation>
    </message>
    <message>
        <source>readings: %1</source>
        <translation>odczyty: %1</translation>
    </message>
    <message>
        <source>rev. %1</source>
        <translation>wyd. %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FleetPanel</name>
    <message>
        <source>Due</source>
        <translation>Terminy</translation>
    </message>
    <message>
        <source>Due (%1)</source>
        <translation>Terminy (%1)</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Flota</translation>
    </message>
    <message>
        <source>Search everything (Ctrl+F)</source>
        <translation>Szukaj wszędzie (Ctrl+F)</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Wyznaczono</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nic nie znaleziono</translation>
    </message>
    <message>
        <source>Search everything</source>
        <translation>Szukaj wszędzie</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::FlightLogPage</name>
    <message>
        <source>Wind from %1° at %2 kt ± %3 kt, airspeed %4 kt ± %5 kt (one standard error), %6 legs.</source>
        <translation>Wiatr z %1°, %2 w ± %3 w, prędkość powietrzna %4 w ± %5 w (błąd standardowy), odcinków: %6.</translation>
    </message>
    <message>
        <source>%1 %2° ± %3°</source>
        <translation>%1 %2° ± %3°</translation>
    </message>
    <message>
        <source>%1 not told</source>
        <translation>%1 nieokreślone</translation>
    </message>
    <message>
        <source>%1 updates: %2 (± one standard error).</source>
        <translation>Aktualizacji %1: %2 (± błąd standardowy).</translation>
    </message>
    <message>
        <source>&amp;Open a log of legs or headings…</source>
        <translation>&amp;Otwórz zapis odcinków lub kursów…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>&amp;Make a swing of it</source>
        <translation>Utwórz &amp;z niego pomiar</translation>
    </message>
    <message>
        <source>What is told</source>
        <translation>Co z tego wynika</translation>
    </message>
    <message>
        <source>Reading… %1 %</source>
        <translation>Wczytywanie… %1 %</translation>
    </message>
    <message>
        <source>A swing in flight</source>
        <translation>Pomiar dewiacji w locie</translation>
    </message>
    <message>
        <source>Legs: track_deg, ground_speed_kt, compass_heading_deg, leg. Continuous: time_s, compass_heading_deg, reference_heading_deg (magnetic) or deviation_deg, leg, current_A:NAME.</source>
        <translation>Odcinki: track_deg, ground_speed_kt, compass_heading_deg, leg. Ciągły: time_s, compass_heading_deg, reference_heading_deg (magnetyczny) lub deviation_deg, leg, current_A:NAZWA.</translation>
    </message>
    <message>
        <source>variation of the legs, E +</source>
        <translation>deklinacja odcinków, E +</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Dewiacja</translation>
    </message>
    <message>
        <source>Choose a compass first</source>
        <translation>Najpierw wybierz busolę</translation>
    </message>
    <message>
        <source>A swing in flight of %1 · %2</source>
        <translation>Pomiar w locie: %1 · %2</translation>
    </message>
    <message>
        <source>Open a log: legs by GPS, or headings beside a reference.</source>
        <translation>Otwórz zapis: odcinki według GPS albo kursy obok wzorca.</translation>
    </message>
    <message>
        <source>Open a log</source>
        <translation>Otwieranie zapisu</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no error of a heading; expected 0.001 to 90 degrees</source>
        <translation>&apos;%1&apos; nie jest błędem kursu; oczekiwano od 0.001 do 90 stopni</translation>
    </message>
    <message numerus="yes">
        <source>It goes on from %n swing(s) in flight on record, recomputed from their readings.</source>
        <translation>
            <numerusform>Kontynuuje od %n pomiaru w locie, przeliczonego z odczytów.</numerusform>
            <numerusform>Kontynuuje od %n pomiarów w locie, przeliczonych z odczytów.</numerusform>
            <numerusform>Kontynuuje od %n pomiarów w locie, przeliczonych z odczytów.</numerusform>
        </translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wiatr</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Zbieżność</translation>
    </message>
    <message>
        <source>means of legs</source>
        <translation>średnie odcinków</translation>
    </message>
    <message>
        <source>Nothing to write yet; open a log first</source>
        <translation>Nie ma jeszcze czego zapisać; najpierw otwórz zapis</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisywanie sprawozdania</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Swing in &amp;flight from a log…</source>
        <translation>Pomiar dewiacji w &amp;locie z zapisu…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Write the &amp;report as PDF…</source>
        <translation>Zapisz &amp;sprawozdanie jako PDF…</translation>
    </message>
    <message>
        <source>Legs: ground velocities of three or more headings lie on a circle about the wind, whose radius is the airspeed, so the heading of each leg follows without a model. Continuous: δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′ is followed by a Kalman filter, without process noise the least-squares solution; χ² of the last 10, 20, 40 and 80 innovations raises an alarm, falsely in one of ten logs of 1400 updates. The means of the legs become the readings of a swing; the next log of the compass goes on from the swings in flight since its last other swing, recomputed from those readings.</source>
        <translation>Odcinki: prędkości względem ziemi na trzech lub więcej kursach leżą na okręgu wokół wiatru, którego promieniem jest prędkość powietrzna, więc kurs każdego odcinka wynika bez modelu. Ciągły: δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′ śledzi filtr Kalmana, bez szumu procesu równy najmniejszym kwadratom; χ² ostatnich 10, 20, 40 i 80 innowacji podnosi alarm, fałszywie w jednym na dziesięć zapisów po 1400 aktualizacji. Średnie odcinków stają się odczytami pomiaru; następny zapis busoli kontynuuje od pomiarów w locie od jej ostatniego innego pomiaru, przeliczonych z tych odczytów.</translation>
    </message>
    <message>
        <source>Hard iron P %1, Q %2, R %3 nT.</source>
        <translation>Żelazo twarde P %1, Q %2, R %3 nT.</translation>
    </message>
    <message>
        <source>Level, where H is %1 nT: %2 (± one standard error).</source>
        <translation>W locie poziomym, gdzie H wynosi %1 nT: %2 (± błąd standardowy).</translation>
    </message>
    <message>
        <source>&amp;Whole sensor model</source>
        <translation>&amp;Cały model czujnika</translation>
    </message>
    <message>
        <source>Soft and hard iron in place of A to E: the log has pitch_deg, roll_deg, horizontal_nT and dip_deg, too.</source>
        <translation>Żelazo miękkie i twarde zamiast od A do E: zapis ma też pitch_deg, roll_deg, horizontal_nT i dip_deg.</translation>
    </message>
    <message>
        <source>begins anew</source>
        <translation>zaczyna od nowa</translation>
    </message>
    <message>
        <source>goes on from %1</source>
        <translation>kontynuuje od %1</translation>
    </message>
    <message>
        <source>The sensor model %1 was kept from a log of this name: if it is the same, it counts twice. Begin anew.</source>
        <translation>Model czujnika %1 zachowano z dziennika o tej nazwie: jeśli to ten sam, policzy się dwa razy. Zacznij od nowa.</translation>
    </message>
    <message>
        <source>It goes on from the sensor model %1.</source>
        <translation>Kontynuuje od modelu czujnika %1.</translation>
    </message>
    <message>
        <source>Nothing to keep yet; open a log first</source>
        <translation>Nie ma jeszcze czego zachować; najpierw otwórz dziennik</translation>
    </message>
    <message>
        <source>It is kept with the compass as %1.</source>
        <translation>Zachowano przy busoli jako %1.</translation>
    </message>
    <message>
        <source>&amp;Keep the sensor model</source>
        <translation>&amp;Zachowaj model czujnika</translation>
    </message>
    <message>
        <source>error of a heading pair; as they scatter</source>
        <translation>błąd pary kursów; według rozrzutu</translation>
    </message>
    <message>
        <source>The whole sensor model begins</source>
        <translation>Cały model czujnika zaczyna się</translation>
    </message>
    <message>
        <source>A sensor model of this compass whose errors are known: the flight adds to it. Begin anew after the iron was changed.</source>
        <translation>Model czujnika tej busoli o znanych błędach: lot go uzupełnia. Po zmianie żelaza zacznij od nowa.</translation>
    </message>
    <message>
        <source>Among the sensor models of the compass, with its errors: the next flight goes on from it.</source>
        <translation>Wśród modeli czujnika tej busoli, z jego błędami: następny lot kontynuuje od niego.</translation>
    </message>
    <message>
        <source>keep the sensor model %1</source>
        <translation>zachowanie modelu czujnika %1</translation>
    </message>
    <message>
        <source>Whole sensor model: sin δ = Σ g (S b + p/H) with b the Earth&apos;s field in the aircraft over H and g what a field along each axis does across the heading read, exact at every attitude (after Poisson; Kayton and Fried 1997, 9.13); level flight tells A to E of it. Kept with the compass, with its errors, it is where the next flight goes on; a circuit that is on is part of it, as the heading is read with it.</source>
        <translation>Cały model czujnika: sin δ = Σ g (S b + p/H), gdzie b jest polem Ziemi w układzie statku powietrznego przez H, a g tym, co pole wzdłuż każdej osi robi w poprzek odczytanego kursu, dokładnie w każdym położeniu (według Poissona; Kayton i Fried 1997, 9.13); lot poziomy mówi z niego A do E. Zachowany przy busoli, z jego błędami, jest tym, od czego następny lot kontynuuje; włączony obwód jest jego częścią, bo z nim odczytuje się kurs.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Gathering</name>
    <message>
        <source>Putting the document together: cancel</source>
        <translation>Składanie dokumentu: anuluj</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedFault</name>
    <message>
        <source>Go on (Enter)</source>
        <translation>Dalej (Enter)</translation>
    </message>
    <message>
        <source>Abandon this swing</source>
        <translation>Przerwij ten pomiar</translation>
    </message>
    <message>
        <source>What was done about the fault? Some words are expected.</source>
        <translation>Co zrobiono z usterką? Oczekiwano kilku słów.</translation>
    </message>
    <message>
        <source>What is the fault? Some words are expected.</source>
        <translation>Jaka to usterka? Oczekiwano kilku słów.</translation>
    </message>
    <message>
        <source>Why is the swing abandoned? Some words are expected; its readings stay on record.</source>
        <translation>Dlaczego pomiar jest przerwany? Oczekiwano kilku słów; odczyty pozostają w zapisie.</translation>
    </message>
    <message>
        <source>Fault: %1. What was done about it?</source>
        <translation>Usterka: %1. Co z nią zrobiono?</translation>
    </message>
    <message>
        <source>This swing was abandoned: %1.</source>
        <translation>Ten pomiar przerwano: %1.</translation>
    </message>
    <message>
        <source>What is the fault? F8 goes back.</source>
        <translation>Jaka to usterka? F8 wraca.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedJob</name>
    <message>
        <source>%1 figures; expected one to three of the same heading</source>
        <translation>wartości: %1; oczekiwano od jednej do trzech na tym samym kursie</translation>
    </message>
    <message>
        <source>the datum says %1°, which is no reading on %2°; turn there, or skip this heading with a reason (F4)</source>
        <translation>wzorzec wskazuje %1°, co nie jest odczytem na kursie %2°; obróć na ten kurs albo pomiń go z podaniem powodu (F4)</translation>
    </message>
    <message>
        <source>Set the astrocompass for %1 UTC: latitude %2°, declination %3°, local hour angle %4°.</source>
        <translation>Nastaw astrokompas na %1 UTC: szerokość %2°, deklinacja słońca %3°, miejscowy kąt godzinny %4°.</translation>
    </message>
    <message>
        <source>the sun tells a heading where the place is known; give the base its latitude and longitude</source>
        <translation>słońce daje kurs tam, gdzie miejsce jest znane; podaj szerokość i długość bazy</translation>
    </message>
    <message>
        <source>Without it C is not told, and the N–S control stays as it is.</source>
        <translation>Bez niego C jest nieokreślone, a regulacja N–S pozostaje bez zmian.</translation>
    </message>
    <message>
        <source>Without it B is not told, and the E–W control stays as it is.</source>
        <translation>Bez niego B jest nieokreślone, a regulacja E–W pozostaje bez zmian.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedPage</name>
    <message>
        <source>Crew display (F11)</source>
        <translation>Ekran dla załogi (F11)</translation>
    </message>
    <message>
        <source>Fault… (F8)</source>
        <translation>Usterka… (F8)</translation>
    </message>
    <message>
        <source>Live (F12)</source>
        <translation>Na żywo (F12)</translation>
    </message>
    <message>
        <source>this swing is not a guided one</source>
        <translation>ten pomiar nie jest prowadzony</translation>
    </message>
    <message>
        <source>A guided swing is of one compass: choose it, or a swing of it, in the tree.</source>
        <translation>Pomiar prowadzony dotyczy jednej busoli: wybierz ją albo jej pomiar w drzewie.</translation>
    </message>
    <message>
        <source>&amp;Guided swing on the ramp</source>
        <translation>Pomiar &amp;prowadzony na płycie</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Guided swing</source>
        <translation>Pomiar prowadzony</translation>
    </message>
    <message>
        <source>Instrument (F3)</source>
        <translation>Przyrząd (F3)</translation>
    </message>
    <message>
        <source>%1 comes in its turn</source>
        <translation>%1 przyjdzie w swojej kolejności</translation>
    </message>
    <message>
        <source>%1 gives true headings, and this swing has no variation: begin it with a site that has one.</source>
        <translation>%1 podaje kursy rzeczywiste, a ten pomiar nie ma deklinacji: zacznij go w miejscu, które ją ma.</translation>
    </message>
    <message>
        <source>One step a page: turn to the heading, type what datum and compass read, Enter. F2 repeats a step, F3 changes the instrument, F4 leaves a heading out and says what that costs, F8 reports a fault, F11 shows the crew&apos;s display and closes it, F12 listens to instruments. A heading that was left out is read at any later time: F2, a click on it in the strip below, or the arrows there and Enter. Every figure is kept as it is typed; an interrupted swing goes on where it stood, from the overview, the tree, the page of its compass or Ctrl+Shift+G.</source>
        <translation>Jeden krok na stronę: ustaw kurs, wpisz wskazania wzorca i busoli, Enter. F2 powtarza krok, F3 zmienia przyrząd, F4 opuszcza kurs i mówi, ile to kosztuje, F8 zgłasza usterkę, F11 pokazuje i zamyka ekran dla załogi, F12 słucha przyrządów. Opuszczony kurs odczytuje się w dowolnej późniejszej chwili: F2, kliknięciem na nim w pasku poniżej albo strzałkami tam i klawiszem Enter. Każda liczba jest zachowywana w trakcie wpisywania; przerwany pomiar idzie dalej od miejsca, w którym stanął: z przeglądu, z drzewa, ze strony busoli albo przez Ctrl+Shift+G.</translation>
    </message>
    <message>
        <source>this guided swing is finished; nothing is added to it</source>
        <translation>ten pomiar prowadzony jest ukończony; niczego się do niego nie dodaje</translation>
    </message>
    <message>
        <source>This guided swing has been ended in another window.</source>
        <translation>Ten pomiar prowadzony zakończono w innym oknie.</translation>
    </message>
    <message>
        <source>This swing has gone on in another window: it is shown as it stands there.</source>
        <translation>Ten pomiar posunął się w innym oknie: pokazano go tak, jak tam stoi.</translation>
    </message>
    <message>
        <source>This swing has gone on in another window: it is shown as it stands there. What was typed here was not stored: %1.</source>
        <translation>Ten pomiar posunął się w innym oknie: pokazano go tak, jak tam stoi. Tego, co tu wpisano, nie zapisano: %1.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedPrepare</name>
    <message>
        <source>engines and electrics</source>
        <translation>silniki i odbiorniki elektryczne</translation>
    </message>
    <message>
        <source>Prepared: to the first heading (Enter)</source>
        <translation>Przygotowano: na pierwszy kurs (Enter)</translation>
    </message>
    <message>
        <source>compass, off</source>
        <translation>busola, wyłączone</translation>
    </message>
    <message>
        <source>compass, on</source>
        <translation>busola, włączone</translation>
    </message>
    <message>
        <source>change</source>
        <translation>zmiana</translation>
    </message>
    <message>
        <source>Interference check, with</source>
        <translation>Próba zakłóceń, włączone:</translation>
    </message>
    <message>
        <source>Every point of the checklist is ticked first</source>
        <translation>Najpierw odhacz każdy punkt listy kontrolnej</translation>
    </message>
    <message>
        <source>The compass changes by up to %1° with %2: a significant difference is cured first. No limit is sourced; you decide.</source>
        <translation>Wskazanie busoli zmienia się do %1° po włączeniu: %2. Znaczącą różnicę usuwa się najpierw. Źródła nie podają granicy; decyzja należy do ciebie.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedReview</name>
    <message>
        <source>Accept and make the record</source>
        <translation>Przyjmij i utwórz zapis</translation>
    </message>
    <message>
        <source>A control was turned again</source>
        <translation>Regulację obrócono ponownie</translation>
    </message>
    <message>
        <source>for</source>
        <translation>dla kursu</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnetyczny</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>dewiacja</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>reszta</translation>
    </message>
    <message>
        <source>steer</source>
        <translation>steruj</translation>
    </message>
    <message>
        <source>with</source>
        <translation>konfiguracja</translation>
    </message>
    <message>
        <source>who accepts the swing</source>
        <translation>kto przyjmuje pomiar</translation>
    </message>
    <message>
        <source>the compass now reads</source>
        <translation>busola wskazuje teraz</translation>
    </message>
    <message>
        <source>On the heading of the row that is chosen, where the aircraft stands now. Every reading of the check swing is void then.</source>
        <translation>Na kursie wybranego wiersza, na którym stoi teraz statek powietrzny. Wszystkie odczyty pomiaru kontrolnego tracą wtedy ważność.</translation>
    </message>
    <message>
        <source>A = %1° was taken out by turning the compass; residual = deviation − A.</source>
        <translation>A = %1° usunięto przez obrót busoli; reszta = dewiacja − A.</translation>
    </message>
    <message>
        <source>A = %1° was left in: %2.</source>
        <translation>A = %1° pozostawiono: %2.</translation>
    </message>
    <message>
        <source>Make the record</source>
        <translation>Utwórz zapis</translation>
    </message>
    <message>
        <source>Largest residual %1° on %2</source>
        <translation>Największa reszta %1° na kursie %2</translation>
    </message>
    <message>
        <source>. No limit is set for this compass.</source>
        <translation>. Dla tej busoli nie ustalono wartości dopuszczalnej.</translation>
    </message>
    <message>
        <source>: within %1.</source>
        <translation>: w granicach %1.</translation>
    </message>
    <message>
        <source>: OUT OF LIMITS, %1 is allowed.</source>
        <translation>: POZA GRANICAMI, dopuszczalne %1.</translation>
    </message>
    <message>
        <source>Who accepts the swing? A name is expected.</source>
        <translation>Kto przyjmuje pomiar? Oczekiwano nazwiska.</translation>
    </message>
    <message>
        <source>What does the compass read after the control was turned, on the heading of the row that is chosen? One figure is expected.</source>
        <translation>Co wskazuje busola po obrocie regulacji na kursie wybranego wiersza? Oczekiwano jednej wartości.</translation>
    </message>
    <message>
        <source>Read this one again (F2)</source>
        <translation>Odczytaj ten jeszcze raz (F2)</translation>
    </message>
    <message>
        <source>skipped: %1</source>
        <translation>opuszczono: %1</translation>
    </message>
    <message>
        <source>A control is turned on a heading that was read; choose another row.</source>
        <translation>Regulację obraca się na kursie, który odczytano; wybierz inny wiersz.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedStart</name>
    <message>
        <source>Begin (Ctrl+Enter)</source>
        <translation>Zacznij (Ctrl+Enter)</translation>
    </message>
    <message>
        <source>&amp;Procedure:</source>
        <translation>&amp;Metoda:</translation>
    </message>
    <message>
        <source>&amp;Check swing:</source>
        <translation>Pomiar &amp;kontrolny:</translation>
    </message>
    <message>
        <source>8 headings</source>
        <translation>8 kursów</translation>
    </message>
    <message>
        <source>12 headings</source>
        <translation>12 kursów</translation>
    </message>
    <message>
        <source>24 headings</source>
        <translation>24 kursy</translation>
    </message>
    <message>
        <source>&amp;Datum:</source>
        <translation>&amp;Wzorzec:</translation>
    </message>
    <message>
        <source>&amp;Site:</source>
        <translation>M&amp;iejsce:</translation>
    </message>
    <message>
        <source>Da&amp;te (UTC):</source>
        <translation>Da&amp;ta (UTC):</translation>
    </message>
    <message>
        <source>&amp;Radio:</source>
        <translation>&amp;Radio:</translation>
    </message>
    <message>
        <source>&amp;Engines:</source>
        <translation>&amp;Silniki:</translation>
    </message>
    <message>
        <source>as running, 1500 rpm</source>
        <translation>na przykład pracują, 1500 obr/min</translation>
    </message>
    <message>
        <source>E&amp;lectrics:</source>
        <translation>Odbiorniki &amp;el.:</translation>
    </message>
    <message>
        <source>loads on and off</source>
        <translation>odbiorniki włączone i wyłączone</translation>
    </message>
    <message>
        <source>&amp;Further configurations:</source>
        <translation>Dalsze kon&amp;figuracje:</translation>
    </message>
    <message>
        <source>each read once more, as radio on; pitot heat on</source>
        <translation>każda odczytana jeszcze raz, na przykład radio włączone; ogrzewanie rurki Pitota włączone</translation>
    </message>
    <message>
        <source>Datum read &amp;by:</source>
        <translation>W&amp;zorzec odczytał:</translation>
    </message>
    <message>
        <source>Compass read b&amp;y:</source>
        <translation>&amp;Busolę odczytał:</translation>
    </message>
    <message>
        <source>&amp;Adjusted by:</source>
        <translation>K&amp;ompensował:</translation>
    </message>
    <message>
        <source>Reaso&amp;n:</source>
        <translation>Powó&amp;d:</translation>
    </message>
    <message>
        <source>as yearly, compass replaced</source>
        <translation>na przykład coroczny, wymiana busoli</translation>
    </message>
    <message>
        <source>&amp;Work order:</source>
        <translation>Z&amp;lecenie:</translation>
    </message>
    <message>
        <source>Chec&amp;klist, a line each:</source>
        <translation>Lista kontrolna, po &amp;wierszu:</translation>
    </message>
    <message>
        <source>&amp;In spite of that, because:</source>
        <translation>Mimo to, &amp;ponieważ:</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>Not to be used on that day: %1</source>
        <translation>Nie używać tego dnia: %1</translation>
    </message>
    <message>
        <source>The painted lines are out by %1° since they were laid out; this is added to every figure.</source>
        <translation>Namalowane linie odbiegają o %1° od czasu wytyczenia; wartość ta jest dodawana do każdego odczytu.</translation>
    </message>
    <message>
        <source>%1 gives true headings; expected a site with its variation or its position</source>
        <translation>%1 podaje kursy rzeczywiste; oczekiwano miejsca z deklinacją albo położeniem</translation>
    </message>
    <message>
        <source>Not to be used on that day: %1. A reason is expected to swing in spite of that.</source>
        <translation>Nie używać tego dnia: %1. Aby mimo to wykonać pomiar, oczekiwano powodu.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedStation</name>
    <message>
        <source>Next (Enter)</source>
        <translation>Dalej (Enter)</translation>
    </message>
    <message>
        <source>Read again (F2)</source>
        <translation>Odczytaj ponownie (F2)</translation>
    </message>
    <message>
        <source>Skip (F4)</source>
        <translation>Pomiń (F4)</translation>
    </message>
    <message>
        <source>Leave as it is (F5)</source>
        <translation>Pozostaw (F5)</translation>
    </message>
    <message>
        <source>datum reads</source>
        <translation>wzorzec wskazuje</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>from astern</source>
        <translation>od tyłu</translation>
    </message>
    <message>
        <source>As the instrument shows it; up to three figures with spaces between, as 178 178.5 178</source>
        <translation>Jak wskazuje przyrząd; do trzech wartości oddzielonych spacją, na przykład 178 178.5 178</translation>
    </message>
    <message>
        <source>As the compass shows it; up to three figures with spaces between</source>
        <translation>Jak wskazuje busola; do trzech wartości oddzielonych spacją</translation>
    </message>
    <message>
        <source>it now reads</source>
        <translation>wskazuje teraz</translation>
    </message>
    <message>
        <source>turns of the screw, magnets (may stay empty)</source>
        <translation>obroty śruby, magnesy (może pozostać puste)</translation>
    </message>
    <message>
        <source>On %1</source>
        <translation>Na kursie %1</translation>
    </message>
    <message>
        <source>Turn to %1</source>
        <translation>Obróć na kurs %1</translation>
    </message>
    <message>
        <source>The reading of before is void: a control was turned since. Read it again.</source>
        <translation>Wcześniejszy odczyt stracił ważność: od tego czasu obrócono regulację. Odczytaj ponownie.</translation>
    </message>
    <message>
        <source>Index: the aircraft stays where it is</source>
        <translation>Nastawienie: statek powietrzny pozostaje na miejscu</translation>
    </message>
    <message>
        <source>More than %1°: find magnetised parts and demagnetise them before anything is corrected (Tecnam P2002-JF MM 34-20). F8 reports the fault.</source>
        <translation>Ponad %1°: przed kompensacją odszukaj i rozmagnesuj namagnesowane części (Tecnam P2002-JF MM 34-20). F8 zgłasza usterkę.</translation>
    </message>
    <message>
        <source>Nothing can be turned here: %1. F5 leaves it as it is, with a reason.</source>
        <translation>Niczego nie da się tu obrócić: %1. F5 pozostawia stan z podaniem powodu.</translation>
    </message>
    <message>
        <source>. Enter keeps it as it is read.</source>
        <translation>. Enter zapisuje, jak odczytano.</translation>
    </message>
    <message>
        <source>What does the compass read now? One figure is expected.</source>
        <translation>Co wskazuje teraz busola? Oczekiwano jednej wartości.</translation>
    </message>
    <message>
        <source>%1° is wanted, it reads %2°: turn again and type what it reads, or Enter keeps it.</source>
        <translation>Wymagane %1°, wskazuje %2°: obróć ponownie i wpisz wskazanie albo zapisz klawiszem Enter.</translation>
    </message>
    <message>
        <source>There is no reading that can be read again: a control was turned on it.</source>
        <translation>Nie ma odczytu, który można powtórzyć: obrócono na nim regulację.</translation>
    </message>
    <message>
        <source>Why can this heading not be read?</source>
        <translation>Dlaczego nie można odczytać tego kursu?</translation>
    </message>
    <message>
        <source>Why is it left as it is?</source>
        <translation>Dlaczego pozostaje bez zmian?</translation>
    </message>
    <message>
        <source>A reason is expected; Escape goes back.</source>
        <translation>Oczekiwano powodu; Escape wraca.</translation>
    </message>
    <message>
        <source> It can be read later: F2, or its place in the strip below.</source>
        <translation> Można go odczytać później: F2 albo jego miejsce w pasku poniżej.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::GuidedWords</name>
    <message>
        <source>Preparation</source>
        <translation>Przygotowanie</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Nastawienie</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Przegląd</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Zakończono</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Usterka</translation>
    </message>
    <message>
        <source>Abandoned</source>
        <translation>Przerwano</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Stan zastany</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Kompensacja</translation>
    </message>
    <message>
        <source>Check swing</source>
        <translation>Pomiar kontrolny</translation>
    </message>
    <message>
        <source>Read N, E, S and W; on S the N–S screw takes out C, on W the E–W screw takes out B; check swing; A by turning the compass in its mount (worksheet to CAP 562).</source>
        <translation>Odczytaj N, E, S i W; na S śruba N–S usuwa C, na W śruba E–W usuwa B; pomiar kontrolny; A przez obrót busoli w obsadzie (arkusz do CAP 562).</translation>
    </message>
    <message>
        <source>On N and E all of the error is taken out, on S and W half of what is left; check swing; A by turning the compass in its mount (Barfield 56-101-01200).</source>
        <translation>Na N i E usuwa się cały błąd, na S i W połowę pozostałego; pomiar kontrolny; A przez obrót busoli w obsadzie (Barfield 56-101-01200).</translation>
    </message>
    <message>
        <source>Read N, E, S and W; the mount is turned by their mean, then B on W and C on N; check swing.</source>
        <translation>Odczytaj N, E, S i W; obsadę obraca się o ich średnią, potem B na W i C na N; pomiar kontrolny.</translation>
    </message>
    <message>
        <source>Read N, E, S and W untouched; the flux valve is turned by their mean, then C on N and B on E; check swing (Duncan Aviation, after MIL-STD-765A practice).</source>
        <translation>Odczytaj N, E, S i W bez regulacji; czujnik indukcyjny obraca się o ich średnią, potem C na N i B na E; pomiar kontrolny (Duncan Aviation, według praktyki MIL-STD-765A).</translation>
    </message>
    <message>
        <source>Nothing is touched: the check swing alone.</source>
        <translation>Niczego się nie rusza: sam pomiar kontrolny.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>NE</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>SW</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>NW</translation>
    </message>
    <message>
        <source>Error %1°: turn the %2 until all of it is gone, and the compass reads</source>
        <translation>Błąd %1°: obracaj (%2), aż zniknie cały, a busola wskaże</translation>
    </message>
    <message>
        <source>Half of the error is %1°: turn the %2 until the compass reads</source>
        <translation>Połowa błędu to %1°: obracaj (%2), aż busola wskaże</translation>
    </message>
    <message>
        <source>%1 = %2°: turn the %3 until the compass reads</source>
        <translation>%1 = %2°: obracaj (%3), aż busola wskaże</translation>
    </message>
    <message>
        <source>%1 · step %2 of %3</source>
        <translation>%1 · krok %2 z %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Skipped: %1. </source>
        <translation>Pominięto: %1. </translation>
    </message>
    <message>
        <source>What was read does not tell a curve.</source>
        <translation>Odczyty nie wyznaczają krzywej.</translation>
    </message>
    <message>
        <source>The curve is known to ±%1 of a reading&apos;s error at %2 instead of ±%3.</source>
        <translation>Krzywa jest znana z dokładnością ±%1 błędu odczytu na kursie %2 zamiast ±%3.</translation>
    </message>
    <message>
        <source> D and E are not told any more.</source>
        <translation> Nie można już określić D i E.</translation>
    </message>
    <message>
        <source>the bearing of the shadow from the nose</source>
        <translation>namiar cienia od nosa</translation>
    </message>
    <message>
        <source>the sight reads the reciprocal: about %1</source>
        <translation>celownik wskazuje kurs przeciwny: około %1</translation>
    </message>
    <message>
        <source>the sight reads the heading: about %1</source>
        <translation>celownik wskazuje kurs: około %1</translation>
    </message>
    <message>
        <source>the line of %1</source>
        <translation>linia %1</translation>
    </message>
    <message>
        <source>it shows true: about %1</source>
        <translation>wskazuje rzeczywisty: około %1</translation>
    </message>
    <message>
        <source>it shows about %1</source>
        <translation>wskazuje około %1</translation>
    </message>
    <message>
        <source>Instrument: %1</source>
        <translation>Przyrząd: %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Help</name>
    <message>
        <source>The tree at the left has types, aircraft, compasses and swings; a click or Enter opens the page of one. Ctrl+F finds any of them by words.
A new swing (Ctrl+N): name aircraft and compass, type what datum and compass read on each heading; curve, coefficients and verdict follow every key. A guided swing (Ctrl+Shift+G) leads a crew round the base step by step.
Mark it complete, sign it, and print report and card: all in the menus Swing and File. What is signed is frozen; an amendment is a new revision.
Every change can be undone (Ctrl+Z), and is on the drive as soon as a field is left: there is no Save. File keeps copies: Save a copy, Back up now, Restore.
F1 tells about the page in front. Deviation is magnetic minus compass, east positive, everywhere.</source>
        <translation>Drzewo po lewej ma typy, statki powietrzne, busole i pomiary; kliknięcie lub Enter otwiera stronę. Ctrl+F znajduje każdy z nich po słowach.
Nowy pomiar (Ctrl+N): podaj statek powietrzny i busolę, wpisz wskazania wzorca i busoli na każdym kursie; krzywa, współczynniki i ocena nadążają za każdym klawiszem. Pomiar prowadzony (Ctrl+Shift+G) prowadzi załogę po kręgu krok po kroku.
Oznacz go jako ukończony, podpisz, wydrukuj sprawozdanie i tablicę: wszystko w menu Pomiar i Plik. Co podpisano, jest zamrożone; poprawka jest nowym wydaniem.
Każdą zmianę można cofnąć (Ctrl+Z) i jest ona na dysku, gdy tylko opuści się pole: nie ma polecenia Zapisz. Plik przechowuje kopie: Zapisz kopię, Kopia zapasowa teraz, Przywróć.
F1 objaśnia bieżącą stronę. Dewiacja to kurs magnetyczny minus kompasowy, wschodnia dodatnia, wszędzie.</translation>
    </message>
    <message>
        <source>On the page of a swing a click on a coefficient, or Enter on it, opens where it comes from: the formula, and the figures of this swing in it. Escape closes it.
Approximate coefficients: δ = A + B sin ψ&apos; + C cos ψ&apos; + D sin 2ψ&apos; + E cos 2ψ&apos;, fitted to all readings by least squares; δ is magnetic minus compass, ψ&apos; the compass heading.
On the cardinal headings alone that is A = (δN + δE + δS + δW) / 4, B = (δE − δW) / 2, C = (δN − δS) / 2; the quadrantals give D = (δNE − δSE + δSW − δNW) / 4, and E = (δN − δE + δS − δW) / 4.
What stands behind ± is the 95 % interval that the scatter of the readings leaves; rms is that scatter. Every number of the report names its method at the foot of the page.</source>
        <translation>Na stronie pomiaru kliknięcie na współczynniku albo Enter na nim otwiera jego pochodzenie: wzór i podstawione w nim liczby tego pomiaru. Escape zamyka.
Współczynniki przybliżone: δ = A + B sin ψ&apos; + C cos ψ&apos; + D sin 2ψ&apos; + E cos 2ψ&apos;, dopasowane do wszystkich odczytów metodą najmniejszych kwadratów; δ to kurs magnetyczny minus kompasowy, ψ&apos; kurs kompasowy.
Na samych kursach głównych jest to A = (δN + δE + δS + δW) / 4, B = (δE − δW) / 2, C = (δN − δS) / 2; kursy pośrednie dają D = (δNE − δSE + δSW − δNW) / 4, a E = (δN − δE + δS − δW) / 4.
Po znaku ± stoi przedział 95 %, który pozostawia rozrzut odczytów; rms to ten rozrzut. Każda liczba sprawozdania podaje swoją metodę u dołu strony.</translation>
    </message>
    <message>
        <source>Lubberline is free software: you may use, study, share and change it under the GNU General Public License, version 3 or any later version. It comes without any warranty.</source>
        <translation>Lubberline jest wolnym oprogramowaniem: wolno go używać, badać, przekazywać i zmieniać na warunkach Powszechnej Licencji Publicznej GNU, w wersji 3 lub dowolnej późniejszej. Nie daje się na niego żadnej gwarancji.</translation>
    </message>
    <message>
        <source>Copy or save the lines below, write down what was done and what happened, and send them to whoever keeps the program for you. They have nothing of your records in them.</source>
        <translation>Skopiuj lub zapisz poniższe wiersze, dopisz, co zrobiono i co się stało, i wyślij temu, kto opiekuje się programem. Nie ma w nich niczego z zapisów.</translation>
    </message>
    <message>
        <source>deviation δ</source>
        <translation>dewiacja δ</translation>
    </message>
    <message>
        <source>magnetic heading minus compass heading; east positive: what is added to the compass to get magnetic</source>
        <translation>kurs magnetyczny minus kurs kompasowy; wschodnia dodatnia: to, co dodaje się do kompasowego, by otrzymać magnetyczny</translation>
    </message>
    <message>
        <source>variation</source>
        <translation>deklinacja</translation>
    </message>
    <message>
        <source>angle from true to magnetic north at a place and date, east positive; also called declination</source>
        <translation>kąt od północy rzeczywistej do magnetycznej w danym miejscu i dniu, wschodnia dodatnia; zwana też deklinacją</translation>
    </message>
    <message>
        <source>dip</source>
        <translation>inklinacja</translation>
    </message>
    <message>
        <source>angle of the Earth&apos;s field below the horizontal</source>
        <translation>kąt pola Ziemi pod poziomem</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>pensacyjny</translation>
    </message>
    <message>
        <source>deviation measured on a round of headings, with what stood on the aircraft then</source>
        <translation>dewiacja zmierzona na kolejnych kursach dookoła, z tym, co wtedy było na statku powietrznym</translation>
    </message>
    <message>
        <source>correction swing</source>
        <translation>pomiar kompensacyjny</translation>
    </message>
    <message>
        <source>a swing in which the compensator is turned; a check swing only measures</source>
        <translation>pomiar, w którym obraca się kompensator; pomiar kontrolny tylko mierzy</translation>
    </message>
    <message>
        <source>as found, as left</source>
        <translation>stan zastany, stan pozostawiony</translation>
    </message>
    <message>
        <source>before anything was adjusted; after it</source>
        <translation>przed jakąkolwiek regulacją; po niej</translation>
    </message>
    <message>
        <source>datum</source>
        <translation>wzorzec</translation>
    </message>
    <message>
        <source>what the magnetic heading is read from: a sight or landing compass, a painted line, the sun</source>
        <translation>to, z czego odczytuje się kurs magnetyczny: celownik lub busola wzorcowa, namalowana linia, słońce</translation>
    </message>
    <message>
        <source>nominal heading</source>
        <translation>kurs nominalny</translation>
    </message>
    <message>
        <source>the heading that the aircraft was to stand on; what was read is the datum</source>
        <translation>kurs, na którym statek powietrzny miał stanąć; odczytany jest wzorcem</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>the same on all headings: lubber line, mounting, datum</source>
        <translation>takie samo na wszystkich kursach: kreska kursowa, mocowanie, wzorzec</translation>
    </message>
    <message>
        <source>B, C</source>
        <translation>B, C</translation>
    </message>
    <message>
        <source>once round: hard iron fore and aft, and athwart</source>
        <translation>raz na obrót: żelazo twarde wzdłuż i w poprzek</translation>
    </message>
    <message>
        <source>D, E</source>
        <translation>D, E</translation>
    </message>
    <message>
        <source>twice round: soft iron</source>
        <translation>dwa razy na obrót: żelazo miękkie</translation>
    </message>
    <message>
        <source>exact coefficients</source>
        <translation>współczynniki dokładne</translation>
    </message>
    <message>
        <source>Smith&apos;s of large deviations, where B and C no longer just add up</source>
        <translation>Smitha, dla dużych dewiacji, gdzie B i C nie dają się już po prostu dodać</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>reszta</translation>
    </message>
    <message>
        <source>what a fit leaves of a reading</source>
        <translation>to, co dopasowanie zostawia z odczytu</translation>
    </message>
    <message>
        <source>hard iron</source>
        <translation>żelazo twarde</translation>
    </message>
    <message>
        <source>field of what is magnetised and stays with the aircraft; in nT</source>
        <translation>pole tego, co namagnesowane i zostaje ze statkiem powietrznym; w nT</translation>
    </message>
    <message>
        <source>soft iron</source>
        <translation>żelazo miękkie</translation>
    </message>
    <message>
        <source>field that the Earth&apos;s field induces in the aircraft</source>
        <translation>pole, które pole Ziemi wzbudza w statku powietrznym</translation>
    </message>
    <message>
        <source>limits profile</source>
        <translation>zestaw wartości dopuszczalnych</translation>
    </message>
    <message>
        <source>what a compass is held against, with its document</source>
        <translation>to, z czym porównuje się busolę, z dokumentem</translation>
    </message>
    <message>
        <source>card</source>
        <translation>tablica</translation>
    </message>
    <message>
        <source>FOR a magnetic heading STEER by compass: the placard beside the compass</source>
        <translation>NA kurs magnetyczny STERUJ według busoli: tabliczka przy busoli</translation>
    </message>
    <message>
        <source>slip</source>
        <translation>pomyłka</translation>
    </message>
    <message>
        <source>a reading that does not fit the others, and what it most likely was meant to be</source>
        <translation>odczyt, który nie pasuje do pozostałych, i to, czym najpewniej miał być</translation>
    </message>
    <message>
        <source>compass base</source>
        <translation>krąg dewiacyjny</translation>
    </message>
    <message>
        <source>a surveyed place to swing on</source>
        <translation>pomierzone miejsce do pomiarów dewiacji</translation>
    </message>
    <message>
        <source>revision</source>
        <translation>wydanie</translation>
    </message>
    <message>
        <source>an amendment of what was signed; the one before stays</source>
        <translation>poprawka tego, co podpisano; poprzednie zostaje</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>on to the next figure; on a row of a list: opens it</source>
        <translation>do następnej liczby; na wierszu listy: otwiera go</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>closes the message above the page; in a field: what was there before</source>
        <translation>zamyka komunikat nad stroną; w polu: to, co było przedtem</translation>
    </message>
    <message>
        <source>= in the readings</source>
        <translation>= w odczytach</translation>
    </message>
    <message>
        <source>the nominal heading as read</source>
        <translation>kurs zadany jako odczytany</translation>
    </message>
    <message>
        <source>Alt and an underlined letter</source>
        <translation>Alt i podkreślona litera</translation>
    </message>
    <message>
        <source>that menu, field or button</source>
        <translation>to menu, pole lub przycisk</translation>
    </message>
    <message>
        <source>F2, F4, F8 in a guided swing</source>
        <translation>F2, F4, F8 w pomiarze prowadzonym</translation>
    </message>
    <message>
        <source>read a step again, leave it out, report a fault</source>
        <translation>powtórz krok, opuść go, zgłoś usterkę</translation>
    </message>
    <message>
        <source>F6, F7, F12 in a guided swing</source>
        <translation>F6, F7, F12 w pomiarze prowadzonym</translation>
    </message>
    <message>
        <source>take what is heard as datum, as compass; listen to instruments</source>
        <translation>weź to, co słychać, jako wzorzec, jako busolę; słuchaj przyrządów</translation>
    </message>
    <message>
        <source>Data that are built in</source>
        <translation>Dane wbudowane</translation>
    </message>
    <message>
        <source>World Magnetic Model 2025 (WMM)</source>
        <translation>Światowy Model Magnetyczny 2025 (WMM)</translation>
    </message>
    <message>
        <source>NOAA NCEI and British Geological Survey</source>
        <translation>NOAA NCEI i British Geological Survey</translation>
    </message>
    <message>
        <source>public domain</source>
        <translation>domena publiczna</translation>
    </message>
    <message>
        <source>IAGA Division V-MOD, doi 10.5281/zenodo.14012302</source>
        <translation>IAGA Division V-MOD, doi 10.5281/zenodo.14012302</translation>
    </message>
    <message>
        <source>coastlines</source>
        <translation>linie brzegowe</translation>
    </message>
    <message>
        <source>samples of swings</source>
        <translation>próbki pomiarów</translation>
    </message>
    <message>
        <source>the manuals that they name</source>
        <translation>instrukcje, które podają</translation>
    </message>
    <message>
        <source>figures, with their source</source>
        <translation>liczby, ze źródłem</translation>
    </message>
    <message>
        <source>Parts of the program</source>
        <translation>Części programu</translation>
    </message>
    <message>
        <source>window, documents, storage</source>
        <translation>okno, dokumenty, przechowywanie</translation>
    </message>
    <message>
        <source>plots: based in part on the work of the Qwt project (http://qwt.sf.net)</source>
        <translation>wykresy: oparte częściowo na pracy projektu Qwt (http://qwt.sf.net)</translation>
    </message>
    <message>
        <source>LGPL-2.1, Qwt exceptions</source>
        <translation>LGPL-2.1, wyjątki Qwt</translation>
    </message>
    <message>
        <source>Fourier transforms</source>
        <translation>transformaty Fouriera</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>algebra liniowa</translation>
    </message>
    <message>
        <source>the sums of the Earth&apos;s field</source>
        <translation>sumy pola Ziemi</translation>
    </message>
    <message>
        <source>quantiles</source>
        <translation>kwantyle</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>wiersz poleceń</translation>
    </message>
    <message>
        <source>the data inside a report</source>
        <translation>dane wewnątrz sprawozdania</translation>
    </message>
    <message>
        <source>QR codes</source>
        <translation>kody QR</translation>
    </message>
    <message>
        <source>the database</source>
        <translation>baza danych</translation>
    </message>
    <message>
        <source>An empty database</source>
        <translation>Pusta baza danych</translation>
    </message>
    <message>
        <source>Page of an aircraft</source>
        <translation>Strona statku powietrznego</translation>
    </message>
    <message>
        <source>Page of a swing</source>
        <translation>Strona pomiaru</translation>
    </message>
    <message>
        <source>Overview of the fleet</source>
        <translation>Przegląd floty</translation>
    </message>
    <message>
        <source>check sum of those data</source>
        <translation>suma kontrolna tych danych</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::HelpPage</name>
    <message>
        <source>&amp;Copy this</source>
        <translation>&amp;Kopiuj to</translation>
    </message>
    <message>
        <source>Save &amp;as text…</source>
        <translation>Zapisz j&amp;ako tekst…</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>Tematy</translation>
    </message>
    <message>
        <source>Text of the topic</source>
        <translation>Tekst tematu</translation>
    </message>
    <message>
        <source>Save as text</source>
        <translation>Zapisywanie jako tekst</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Tekst (*.txt)</translation>
    </message>
    <message>
        <source>&amp;Help on this page</source>
        <translation>&amp;Pomoc do tej strony</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>Spis &amp;treści</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Skróty klawiszowe</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>Słow&amp;niczek</translation>
    </message>
    <message>
        <source>Where a &amp;number comes from</source>
        <translation>Skąd pochodzi &amp;liczba</translation>
    </message>
    <message>
        <source>&amp;Licences and data sources</source>
        <translation>L&amp;icencje i źródła danych</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>&amp;Zgłoś problem…</translation>
    </message>
    <message>
        <source>&amp;About this program and database</source>
        <translation>&amp;O programie i bazie danych</translation>
    </message>
    <message>
        <source>Topics at the left, the one that is chosen at the right. F1 on any page opens its topic; a topic is copied or saved as text with the buttons above.</source>
        <translation>Tematy po lewej, wybrany po prawej. F1 na każdej stronie otwiera jej temat; temat kopiuje się lub zapisuje jako tekst przyciskami powyżej.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::HelpTopics</name>
    <message>
        <source>Everywhere</source>
        <translation>Wszędzie</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Baza danych</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Aircraft, compasses, swings</source>
        <translation>Statki powietrzne, busole, pomiary</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>Aircraft magnetic deviation: from the readings to the correction card. Deviation = magnetic − compass, east positive.
Based in part on the work of the Qwt project (http://qwt.sf.net). Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>Dewiacja magnetyczna statków powietrznych: od odczytów do tablicy dewiacji. Dewiacja = kurs magnetyczny − kompasowy, wschodnia dodatnia.
Oparte częściowo na pracy projektu Qwt (http://qwt.sf.net). Wolne oprogramowanie na licencji GNU GPL w wersji 3 lub późniejszej, bez żadnej gwarancji.</translation>
    </message>
    <message>
        <source>locale %1, time %2</source>
        <translation>ustawienia regionalne %1, czas %2</translation>
    </message>
    <message>
        <source>screen %1x%2, scale %3, window %4x%5</source>
        <translation>ekran %1x%2, skala %3, okno %4x%5</translation>
    </message>
    <message>
        <source>database of %1 bytes%2</source>
        <translation>baza, bajtów: %1%2</translation>
    </message>
    <message>
        <source>, read only</source>
        <translation>, tylko do odczytu</translation>
    </message>
    <message>
        <source>undo steps %1, last: %2</source>
        <translation>kroków do cofnięcia %1, ostatni: %2</translation>
    </message>
    <message>
        <source>What was done:</source>
        <translation>Co zrobiono:</translation>
    </message>
    <message>
        <source>What happened, and what was expected:</source>
        <translation>Co się stało i czego oczekiwano:</translation>
    </message>
    <message>
        <source>How to begin</source>
        <translation>Jak zacząć</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Skróty klawiszowe</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>Słowniczek</translation>
    </message>
    <message>
        <source>Where a number comes from</source>
        <translation>Skąd pochodzi liczba</translation>
    </message>
    <message>
        <source>Licences and data sources</source>
        <translation>Licencje i źródła danych</translation>
    </message>
    <message>
        <source>This program and this database</source>
        <translation>Ten program i ta baza danych</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>Zgłaszanie problemu</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::HistoryChart</name>
    <message>
        <source>largest |deviation|</source>
        <translation>największa |dewiacja|</translation>
    </message>
    <message>
        <source>date of the swing</source>
        <translation>data pomiaru</translation>
    </message>
    <message>
        <source>coefficient, deviation (°)</source>
        <translation>współczynnik, dewiacja (°)</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>dopuszczalne</translation>
    </message>
    <message>
        <source>limit ±%1°</source>
        <translation>dopuszczalne ±%1°</translation>
    </message>
    <message>
        <source>No swings with results yet.</source>
        <translation>Brak jeszcze pomiarów z wynikami.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::HistoryPanel</name>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Odtwarzaj</translation>
    </message>
    <message>
        <source>The swings one after the other</source>
        <translation>Pomiary, jeden po drugim</translation>
    </message>
    <message>
        <source>Computing.</source>
        <translation>Trwa obliczanie.</translation>
    </message>
    <message>
        <source>It is not expected to reach its limit: no date to tell.</source>
        <translation>Nie oczekuje się, by osiągnęła granicę: nie ma daty do podania.</translation>
    </message>
    <message>
        <source>No limit is known of this compass, so no date by which it is reached.</source>
        <translation>Nie są znane wartości dopuszczalne tej busoli, więc nie ma daty ich osiągnięcia.</translation>
    </message>
    <message>
        <source>%1 drifts by %2° a year (95 %: %3 to %4).</source>
        <translation>%1 dryfuje o %2° rocznie (95 %: od %3 do %4).</translation>
    </message>
    <message>
        <source>Its limit is reached by %1 in half of the futures, by %2 in one of twenty.</source>
        <translation>Granicę osiąga do %1 w połowie przebiegów przyszłości, do %2 w jednym na dwadzieścia.</translation>
    </message>
    <message>
        <source>No jump and no drift of it is told.</source>
        <translation>Nie stwierdzono w niej skoku ani dryfu.</translation>
    </message>
    <message>
        <source>Filled: as found; open or dashed: as left. Bars: 95 % by the readings.</source>
        <translation>Pełne: stan zastany; puste lub kreskowane: pozostawiony. Słupki: 95 % według odczytów.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::HistoryPlot</name>
    <message>
        <source>Coefficients over time</source>
        <translation>Współczynniki w czasie</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::InflightWords</name>
    <message>
        <source>heading read (°)</source>
        <translation>kurs odczytany (°)</translation>
    </message>
    <message>
        <source>deviation = magnetic − compass (°, east +)</source>
        <translation>dewiacja = magnetyczny − kompasowy (°, E +)</translation>
    </message>
    <message>
        <source>%1: </source>
        <translation>%1: </translation>
    </message>
    <message>
        <source>fit %1°</source>
        <translation>dopasowanie %1°</translation>
    </message>
    <message>
        <source> ± %1° (95 %)</source>
        <translation> ± %1° (95 %)</translation>
    </message>
    <message>
        <source>mean of %1 reports %2°</source>
        <translation>średnia z %1 meldunków %2°</translation>
    </message>
    <message>
        <source>no report in these 10°</source>
        <translation>brak meldunku w tych 10°</translation>
    </message>
    <message>
        <source>headings read; full radius: %1 reports in 10°</source>
        <translation>kursy odczytane; pełny promień: %1 meldunków na 10°</translation>
    </message>
    <message>
        <source>%1 to %2: %3 reports</source>
        <translation>od %1 do %2: %3 meldunków</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>czas (s)</translation>
    </message>
    <message>
        <source>coefficient (°, east +)</source>
        <translation>współczynnik (°, E +)</translation>
    </message>
    <message>
        <source>%1 s: %2 (± one standard error)</source>
        <translation>%1 s: %2 (± błąd standardowy)</translation>
    </message>
    <message>
        <source>reports (some of them)</source>
        <translation>meldunki (niektóre)</translation>
    </message>
    <message>
        <source>means over 10°</source>
        <translation>średnie co 10°</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>dopasowanie</translation>
    </message>
    <message>
        <source>95 % band, by flights</source>
        <translation>pasmo 95 %, według lotów</translation>
    </message>
    <message>
        <source>no report of this aircraft can be used</source>
        <translation>żadnego meldunku tego statku powietrznego nie można użyć</translation>
    </message>
    <message>
        <source>no headings</source>
        <translation>brak kursów</translation>
    </message>
    <message>
        <source>A (bands: two standard errors)</source>
        <translation>A (pasma: dwa błędy standardowe)</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarm</translation>
    </message>
    <message>
        <source>the headings so far do not tell the coefficients</source>
        <translation>dotychczasowe kursy nie określają współczynników</translation>
    </message>
    <message>
        <source>ground velocity %1 kt towards %2</source>
        <translation>prędkość względem ziemi %1 w ku %2</translation>
    </message>
    <message>
        <source>ground velocity of a leg, with its true heading</source>
        <translation>prędkość względem ziemi na odcinku, z jego kursem rzeczywistym</translation>
    </message>
    <message>
        <source>airspeed about the wind</source>
        <translation>prędkość powietrzna wokół wiatru</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>wiatr</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::InstallationPanel</name>
    <message>
        <source>Distances of the flux gate</source>
        <translation>Odległości czujnika indukcyjnego</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>at least (m)</source>
        <translation>co najmniej (m)</translation>
    </message>
    <message>
        <source>measured (m)</source>
        <translation>zmierzono (m)</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>ocena</translation>
    </message>
    <message>
        <source>Clear the distances</source>
        <translation>Wyczyść odległości</translation>
    </message>
    <message>
        <source>no distance; expected metres, 0 or more</source>
        <translation>nie jest odległością; oczekiwano metrów, 0 lub więcej</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::InstrumentsPage</name>
    <message>
        <source>Where it shows %1, the aircraft heads %2° magnetic</source>
        <translation>Gdy wskazuje %1, kurs magnetyczny wynosi %2°</translation>
    </message>
    <message>
        <source> at a variation of %1° east</source>
        <translation> przy deklinacji %1° wschodniej</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>&amp;New instrument</source>
        <translation>&amp;Nowy przyrząd</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Usuń</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nazwa:</translation>
    </message>
    <message>
        <source>Kind:</source>
        <translation>Rodzaj:</translation>
    </message>
    <message>
        <source>Maker:</source>
        <translation>Producent:</translation>
    </message>
    <message>
        <source>Serial number:</source>
        <translation>Numer seryjny:</translation>
    </message>
    <message>
        <source>Calibration due:</source>
        <translation>Wzorcowanie do:</translation>
    </message>
    <message>
        <source>From ahead it reads:</source>
        <translation>Od przodu wskazuje:</translation>
    </message>
    <message>
        <source>Its figures are from:</source>
        <translation>Jego wskazania są od:</translation>
    </message>
    <message>
        <source>magnetic north</source>
        <translation>północy magnetycznej</translation>
    </message>
    <message>
        <source>true north</source>
        <translation>północy geograficznej</translation>
    </message>
    <message>
        <source>Added to every figure (°):</source>
        <translation>Dodawane do każdego odczytu (°):</translation>
    </message>
    <message>
        <source>Read to (°):</source>
        <translation>Odczyt co (°):</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <source>No instrument yet.</source>
        <translation>Brak jeszcze przyrządu.</translation>
    </message>
    <message>
        <source>▲ its calibration was due on %1: a swing with it needs a reason</source>
        <translation>▲ termin wzorcowania minął %1: pomiar z nim wymaga uzasadnienia</translation>
    </message>
    <message>
        <source>new instrument</source>
        <translation>nowy przyrząd</translation>
    </message>
    <message>
        <source>removal of %1</source>
        <translation>usunięcie %1</translation>
    </message>
    <message>
        <source>&amp;Datum instruments</source>
        <translation>&amp;Przyrządy odniesienia</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Datum instruments</source>
        <translation>Przyrządy odniesienia</translation>
    </message>
    <message>
        <source>The datum instruments, and what their figures mean: the example under the form shows what heading a figure stands for, which makes a wrong setting plain.</source>
        <translation>Przyrządy odniesienia i znaczenie ich wskazań: przykład pod formularzem pokazuje, jaki kurs oznacza dany odczyt, co ujawnia błędne ustawienie.</translation>
    </message>
    <message>
        <source>Its figure is the bearing of the shadow from the nose, clockwise; with place and time of the reading it gives a true heading.</source>
        <translation>Jego wartością jest namiar cienia od nosa, w prawo; z miejscem i czasem odczytu daje kurs rzeczywisty.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::IronBenchPage</name>
    <message>
        <source>&amp;Iron bench of this compass</source>
        <translation>&amp;Stanowisko żelaza tej busoli</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Wczytaj…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Zapisz…</translation>
    </message>
    <message>
        <source>Iron bench · %1 · %2</source>
        <translation>Stanowisko żelaza · %1 · %2</translation>
    </message>
    <message>
        <source>The computation was cancelled; nothing was stored.</source>
        <translation>Obliczenie przerwano; niczego nie zapisano.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… i jeszcze %n</numerusform>
            <numerusform>… i jeszcze %n</numerusform>
            <numerusform>… i jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>iron bench</source>
        <translation>stanowisko żelaza</translation>
    </message>
    <message>
        <source>Make an iron bench</source>
        <translation>Utworzenie stanowiska żelaza</translation>
    </message>
    <message>
        <source>Load a bench</source>
        <translation>Wczytywanie stanowiska</translation>
    </message>
    <message>
        <source>Save the bench</source>
        <translation>Zapisywanie stanowiska</translation>
    </message>
    <message>
        <source>Describe the ferrous parts, loops and wires round the compass in the tables, or drag them in the drawing: what they do to it is computed at once. The bench is stored with the compass as a sensor model. A state in which parts are moved or switched is ticked above the tables.</source>
        <translation>Opisz w tabelach części ferromagnetyczne, pętle i przewody wokół busoli albo przeciągaj je na rysunku: ich wpływ jest obliczany od razu. Stanowisko jest zapisywane przy busoli jako model czujnika. Stan, w którym części są przesunięte lub włączone, zaznacza się nad tabelami.</translation>
    </message>
    <message>
        <source>Save the &amp;bench…</source>
        <translation>Zapisz &amp;stanowisko…</translation>
    </message>
    <message>
        <source>Not stored: %1</source>
        <translation>Nie zapisano: %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::LengthLimits</name>
    <message>
        <source>A field takes %1 letters at most: the rest was not taken.</source>
        <translation>Pole mieści najwyżej znaków: %1; reszty nie przyjęto.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::LineOfSightPage</name>
    <message>
        <source>&amp;Line of sight of a helmet…</source>
        <translation>&amp;Linia celowania hełmu…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+H</source>
        <translation>Ctrl+Alt+H</translation>
    </message>
    <message>
        <source>Write the &amp;report as PDF…</source>
        <translation>Zapisz &amp;sprawozdanie jako PDF…</translation>
    </message>
    <message>
        <source>Two magnetic sensors tell where a helmet looks in the aircraft: heading of the helmet less heading of the aircraft, each levelled by its own pitch and roll. An error of a tilt turns a heading by up to tan(dip) times itself, iron at the two sensors works opposite ways, and a constant field of the cockpit turns the helmet&apos;s north. Errors that stay are summed with their sign, those by chance as squares; both are carried through the turret&apos;s mount. A field that coils make to track the helmet is not modelled.</source>
        <translation>Dwa czujniki magnetyczne mówią, dokąd hełm patrzy w statku powietrznym: kurs hełmu minus kurs statku, każdy wypoziomowany własnym pochyleniem i przechyleniem. Błąd pochylenia obraca kurs nawet o tan(inklinacji) razy tyle, żelazo przy obu czujnikach działa przeciwnie, a stałe pole kabiny obraca północ hełmu. Błędy stałe sumuje się ze znakiem, przypadkowe jako kwadraty; oba przenosi się przez mocowanie wieżyczki. Pole, które cewki wytwarzają do śledzenia hełmu, nie jest modelowane.</translation>
    </message>
    <message>
        <source>“%1”: %2; expected %3 number(s) from %4 to %5</source>
        <translation>„%1”: %2; oczekiwano liczb w ilości %3, od %4 do %5</translation>
    </message>
    <message>
        <source>Line of sight</source>
        <translation>Linia wzroku</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Przyczyny</translation>
    </message>
    <message>
        <source>A Model JSON of what iron is left in its headings; cancel the question to take it away</source>
        <translation>Plik Model JSON z żelazem, które zostało w kursach; anulowanie pytania go usuwa</translation>
    </message>
    <message>
        <source>Open a sensor model</source>
        <translation>Otwieranie modelu czujnika</translation>
    </message>
    <message>
        <source>Sensor model (*.json)</source>
        <translation>Model czujnika (*.json)</translation>
    </message>
    <message>
        <source>Line of sight of a helmet</source>
        <translation>Linia wzroku hełmu</translation>
    </message>
    <message>
        <source>Earth&apos;s field (nT), dip (° down +)</source>
        <translation>Pole Ziemi (nT), inklinacja (° w dół +)</translation>
    </message>
    <message>
        <source>Aircraft: magnetic heading, pitch, roll (°)</source>
        <translation>Statek powietrzny: kurs magnetyczny, pochylenie, przechylenie (°)</translation>
    </message>
    <message>
        <source>Looking: azimuth, elevation, roll of the helmet (°)</source>
        <translation>Patrzy: azymut, elewacja, przechylenie hełmu (°)</translation>
    </message>
    <message>
        <source>Noise of an axis: aircraft, helmet (nT)</source>
        <translation>Szum osi: statek, hełm (nT)</translation>
    </message>
    <message>
        <source>Pitch and roll sure to: aircraft, helmet (°)</source>
        <translation>Pochylenie i przechylenie pewne do: statek, hełm (°)</translation>
    </message>
    <message>
        <source>Iron left at the aircraft&apos;s sensor</source>
        <translation>Żelazo pozostałe przy czujniku statku powietrznego</translation>
    </message>
    <message>
        <source>Iron left at the helmet&apos;s sensor</source>
        <translation>Żelazo pozostałe przy czujniku hełmu</translation>
    </message>
    <message>
        <source>Field of the cockpit at the helmet: x, y, z (nT)</source>
        <translation>Pole kabiny przy hełmie: x, y, z (nT)</translation>
    </message>
    <message>
        <source>Turret&apos;s mount: roll, pitch, yaw (°)</source>
        <translation>Mocowanie wieżyczki: przechylenie, pochylenie, odchylenie (°)</translation>
    </message>
    <message>
        <source>Its mount sure to (°)</source>
        <translation>Mocowanie pewne do (°)</translation>
    </message>
    <message>
        <source>the Earth&apos;s field is 1000 nT or more, and its dip from −90° to 90°</source>
        <translation>pole Ziemi wynosi 1000 nT lub więcej, a jego inklinacja od −90° do 90°</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisywanie sprawozdania</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>open a model…</source>
        <translation>otwórz model…</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::LiveActions</name>
    <message>
        <source>Start &amp;with the log</source>
        <translation>Zacznij &amp;z zapisem</translation>
    </message>
    <message>
        <source>Sa&amp;ve the actions…</source>
        <translation>Za&amp;pisz czynności…</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Wyczyść</translation>
    </message>
    <message>
        <source>Noted actions</source>
        <translation>Zanotowane czynności</translation>
    </message>
    <message>
        <source>What is switched now</source>
        <translation>Co się teraz przełącza</translation>
    </message>
    <message>
        <source>landing light on: Enter</source>
        <translation>reflektor lądowania wł.: Enter</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>czas (s)</translation>
    </message>
    <message>
        <source>action</source>
        <translation>czynność</translation>
    </message>
    <message>
        <source>Save the actions</source>
        <translation>Zapisywanie czynności</translation>
    </message>
    <message>
        <source>Actions (*.csv)</source>
        <translation>Czynności (*.csv)</translation>
    </message>
    <message>
        <source>Let the log run. Switch one thing at a time, note it with Enter at that moment, and wait ten seconds.</source>
        <translation>Niech zapis trwa. Przełączaj po jednej rzeczy, zanotuj ją klawiszem Enter w tej samej chwili i odczekaj dziesięć sekund.</translation>
    </message>
    <message>
        <source>To note the actions while the log runs: press Start at the moment at which the log begins; its time is then counted from 0.</source>
        <translation>Aby notować czynności podczas zapisu: naciśnij Start w chwili, gdy zapis się zaczyna; jego czas liczy się wtedy od 0.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::LivePanel</name>
    <message>
        <source>Take as datum (F6)</source>
        <translation>Przyjmij jako wzorzec (F6)</translation>
    </message>
    <message>
        <source>Take as compass (F7)</source>
        <translation>Przyjmij jako busolę (F7)</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>port szeregowy</translation>
    </message>
    <message>
        <source>UDP port</source>
        <translation>port UDP</translation>
    </message>
    <message>
        <source>replay of a log</source>
        <translation>odtwarzanie zapisu</translation>
    </message>
    <message>
        <source>Where does it come from? A port or the path of a log is expected.</source>
        <translation>Skąd mają płynąć dane? Oczekiwano portu albo ścieżki zapisu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no baud rate; expected one as 4800 or 38400</source>
        <translation>„%1” nie jest prędkością transmisji; oczekiwano np. 4800 lub 38400</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Połącz</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>&amp;Rozłącz</translation>
    </message>
    <message>
        <source>silent for %1 s</source>
        <translation>cisza od %1 s</translation>
    </message>
    <message numerus="yes">
        <source>%n wrong checksums</source>
        <translation>
            <numerusform>%n błędna suma kontrolna</numerusform>
            <numerusform>%n błędne sumy kontrolne</numerusform>
            <numerusform>%n błędnych sum kontrolnych</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is heard: a heading is expected.</source>
        <translation>Nic nie słychać: oczekiwano kursu.</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>ustalony</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>w prawo</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>w lewo</translation>
    </message>
    <message>
        <source>turns %1 at %2°/s: too fast, slow down to %3 … %4°/s</source>
        <translation>obrót %1, %2°/s: za szybko, zwolnij do %3 … %4°/s</translation>
    </message>
    <message>
        <source>turns %1 at %2°/s: within %3 … %4°/s</source>
        <translation>obrót %1, %2°/s: w granicach %3 … %4°/s</translation>
    </message>
    <message numerus="yes">
        <source>%n headings are negative or beyond 360 and left out.</source>
        <translation>
            <numerusform>%n kurs jest ujemny lub powyżej 360 i został pominięty.</numerusform>
            <numerusform>%n kursy są ujemne lub powyżej 360 i zostały pominięte.</numerusform>
            <numerusform>%n kursów jest ujemnych lub powyżej 360 i zostało pominiętych.</numerusform>
        </translation>
    </message>
    <message>
        <source>A serial port with its baud rate, as /dev/ttyUSB0 4800; a UDP port, as 10110 (from this machine only) or *:10110 (from every machine in the network); or the path of a log</source>
        <translation>Port szeregowy z prędkością, jak /dev/ttyUSB0 4800; port UDP, jak 10110 (tylko z tego komputera) lub *:10110 (z każdego w sieci); albo ścieżka zapisu</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no UDP port; expected a number from 1 to 65535, as 10110, or *:10110 for the whole network</source>
        <translation>&apos;%1&apos; nie jest portem UDP; oczekiwano liczby od 1 do 65535, jak 10110, lub *:10110 dla całej sieci</translation>
    </message>
    <message>
        <source>%1 sentences left out: more come than can be looked at</source>
        <translation>pominięto zdań: %1; przychodzi więcej, niż da się przejrzeć</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>jeszcze żadne</translation>
    </message>
    <message>
        <source>Sentence of the datum</source>
        <translation>Zdanie wzorca</translation>
    </message>
    <message>
        <source>Sentence of the compass</source>
        <translation>Zdanie busoli</translation>
    </message>
    <message>
        <source>%1 kt over ground: a track tells a heading from %2 kt on</source>
        <translation>%1 w. względem ziemi: kąt drogi mówi o kursie dopiero od %2 w.</translation>
    </message>
    <message>
        <source>a track whose speed is not told tells no heading</source>
        <translation>kąt drogi bez podanej prędkości nie mówi o kursie</translation>
    </message>
    <message>
        <source>nothing new is heard</source>
        <translation>nic nowego nie słychać</translation>
    </message>
    <message numerus="yes">
        <source>✓ settled: moves by %1 over %n headings, the last %2 s old</source>
        <translation>
            <numerusform>✓ ustalony: waha się o %1 w %n kursie, ostatni sprzed %2 s</numerusform>
            <numerusform>✓ ustalony: waha się o %1 w %n kursach, ostatni sprzed %2 s</numerusform>
            <numerusform>✓ ustalony: waha się o %1 w %n kursach, ostatni sprzed %2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>moves by %1 over %n headings, the last %2 s old</source>
        <translation>
            <numerusform>waha się o %1 w %n kursie, ostatni sprzed %2 s</numerusform>
            <numerusform>waha się o %1 w %n kursach, ostatni sprzed %2 s</numerusform>
            <numerusform>waha się o %1 w %n kursach, ostatni sprzed %2 s</numerusform>
        </translation>
    </message>
    <message>
        <source>true</source>
        <translation>rzeczywisty</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnetyczny</translation>
    </message>
    <message>
        <source>true; the datum is magnetic, and the swing has no variation</source>
        <translation>rzeczywisty; wzorzec jest magnetyczny, a dewiacja nie ma deklinacji</translation>
    </message>
    <message>
        <source>magnetic; the datum is true, and the swing has no variation</source>
        <translation>magnetyczny; wzorzec jest rzeczywisty, a dewiacja nie ma deklinacji</translation>
    </message>
    <message>
        <source>true; with the variation %2 of the swing it is taken as %1 magnetic</source>
        <translation>rzeczywisty; z deklinacją %2 zostanie przyjęty jako %1 magnetyczny</translation>
    </message>
    <message>
        <source>magnetic; with the variation %2 of the swing it is taken as %1 true</source>
        <translation>magnetyczny; z deklinacją %2 zostanie przyjęty jako %1 rzeczywisty</translation>
    </message>
    <message>
        <source>Nothing that is sent is a reference by itself: choose the sentence that is the datum.</source>
        <translation>Nic z tego, co jest nadawane, samo nie jest wzorcem: wybierz zdanie, które nim jest.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>The heading has not settled yet: it moves by %1 within the window.</source>
        <translation>Kurs jeszcze się nie ustalił: waha się o %1 w oknie pomiaru.</translation>
    </message>
    <message>
        <source>The datum of this swing is read by a person: a live heading is none of its figures. Choose an instrument that sends headings (F3).</source>
        <translation>Wzorzec tej dewiacji odczytuje człowiek: kurs na żywo nie jest jego wskazaniem. Wybierz przyrząd, który nadaje kursy (F3).</translation>
    </message>
    <message>
        <source>The live heading is from another north than the datum, and the swing has no variation: begin it with a site that has one, or choose an instrument that shows what is sent (F3).</source>
        <translation>Kurs na żywo liczony jest od innej północy niż wzorzec, a dewiacja nie ma deklinacji: rozpocznij ją na stanowisku, które ją ma, albo wybierz przyrząd, który pokazuje to, co jest nadawane (F3).</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::LiveReader</name>
    <message>
        <source>closed</source>
        <translation>zamknięte</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>nie da się otworzyć %1: %2</translation>
    </message>
    <message>
        <source>the serial port has vanished</source>
        <translation>port szeregowy zniknął</translation>
    </message>
    <message>
        <source>listening on %1 at %2 baud</source>
        <translation>nasłuch na %1 z prędkością %2</translation>
    </message>
    <message>
        <source>UDP port %1 cannot be used: %2</source>
        <translation>nie można użyć portu UDP %1: %2</translation>
    </message>
    <message>
        <source>listening on UDP port %1, to every machine in the network</source>
        <translation>nasłuch na porcie UDP %1, z każdego komputera w sieci</translation>
    </message>
    <message>
        <source>listening on UDP port %1, to this machine only</source>
        <translation>nasłuch na porcie UDP %1, tylko z tego komputera</translation>
    </message>
    <message>
        <source>replaying %1</source>
        <translation>odtwarzanie %1</translation>
    </message>
    <message>
        <source>the log has ended</source>
        <translation>zapis się skończył</translation>
    </message>
    <message>
        <source>%1; trying again</source>
        <translation>%1; kolejna próba</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::MainWindow</name>
    <message>
        <source>%1 – Lubberline</source>
        <translation>%1 – Lubberline</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Flota</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>tylko do odczytu</translation>
    </message>
    <message>
        <source>all changes saved</source>
        <translation>wszystkie zmiany zapisane</translation>
    </message>
    <message>
        <source>THE LAST CHANGE WAS NOT SAVED</source>
        <translation>OSTATNIEJ ZMIANY NIE ZAPISANO</translation>
    </message>
    <message>
        <source>%1 · %2 · deviation = magnetic − compass, E +</source>
        <translation>%1 · %2 · dewiacja = kurs magnetyczny − kompasowy, E +</translation>
    </message>
    <message>
        <source>This database can only be read: nothing can be changed here.</source>
        <translation>Tę bazę danych można tylko czytać: niczego nie da się tu zmienić.</translation>
    </message>
    <message numerus="yes">
        <source>%n figures or steps could not be stored last time and were kept: %1.</source>
        <translation>
            <numerusform>Ostatnio nie udało się zapisać %n wartości lub kroku; zachowano: %1.</numerusform>
            <numerusform>Ostatnio nie udało się zapisać %n wartości lub kroków; zachowano: %1.</numerusform>
            <numerusform>Ostatnio nie udało się zapisać %n wartości lub kroków; zachowano: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Put them in</source>
        <translation>Wprowadź je</translation>
    </message>
    <message numerus="yes">
        <source>%n were put in.</source>
        <translation>
            <numerusform>Wprowadzono %n.</numerusform>
            <numerusform>Wprowadzono %n.</numerusform>
            <numerusform>Wprowadzono %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>What could not be stored is kept and offered at the next start.</source>
        <translation>To, czego nie udało się zapisać, jest przechowane i zostanie zaproponowane przy następnym uruchomieniu.</translation>
    </message>
    <message>
        <source>new swing</source>
        <translation>nowy pomiar dewiacji</translation>
    </message>
    <message>
        <source>%1 files were dropped; the first is imported.</source>
        <translation>Upuszczono plików: %1; wczytywany jest pierwszy.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Plik</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edycja</translation>
    </message>
    <message>
        <source>&amp;Swing</source>
        <translation>Po&amp;miar</translation>
    </message>
    <message>
        <source>F&amp;leet</source>
        <translation>F&amp;lota</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>Mo&amp;del</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Widok</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Pomo&amp;c</translation>
    </message>
    <message>
        <source>&amp;Export exchange file</source>
        <translation>&amp;Eksportuj plik wymiany</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importuj…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>This &amp;aircraft…</source>
        <translation>&amp;Ten statek powietrzny…</translation>
    </message>
    <message>
        <source>The whole &amp;fleet…</source>
        <translation>Cała &amp;flota…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Za&amp;kończ</translation>
    </message>
    <message>
        <source>Go to the &amp;tree</source>
        <translation>Przejdź do &amp;drzewa</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Cofnij</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ponów</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Cofnij: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Ponów: %1</translation>
    </message>
    <message>
        <source>Degrees and &amp;minutes</source>
        <translation>Stopnie i &amp;minuty</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Ciemny</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>Main tools</source>
        <translation>Główne narzędzia</translation>
    </message>
    <message>
        <source>New swing</source>
        <translation>Nowy pomiar</translation>
    </message>
    <message>
        <source>Guided swing</source>
        <translation>Pomiar prowadzony</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importuj</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Sprawozdanie</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Tablica dewiacji</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <source>Swings, exchange files, reports (*.csv *.txt *.tsv *.json *.pdf);;All files (*)</source>
        <translation>Pomiary, pliki wymiany, sprawozdania (*.csv *.txt *.tsv *.json *.pdf);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Another file is being read or written. Wait for it, or cancel it.</source>
        <translation>Trwa odczyt lub zapis innego pliku. Poczekaj na jego koniec albo go anuluj.</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>Wczytywanie %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was changed.</source>
        <translation>Anulowano: niczego nie zmieniono.</translation>
    </message>
    <message>
        <source>Name the aircraft…</source>
        <translation>Podaj statek powietrzny…</translation>
    </message>
    <message>
        <source>fleet</source>
        <translation>flota</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Exchange files (*.lubberline.json)</source>
        <translation>Pliki wymiany (*.lubberline.json)</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Eksportowanie</translation>
    </message>
    <message>
        <source>Backup written: %1</source>
        <translation>Zapisano kopię zapasową: %1</translation>
    </message>
    <message>
        <source>&amp;Reset the zoom</source>
        <translation>&amp;Przywróć skalę</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Cop&amp;y the plot</source>
        <translation>&amp;Kopiuj wykres</translation>
    </message>
    <message>
        <source>E&amp;xport the plot…</source>
        <translation>&amp;Eksportuj wykres…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>%1 – %2 – Lubberline</source>
        <translation>%1 – %2 – Lubberline</translation>
    </message>
    <message>
        <source>What was kept for recovery is not used: %1</source>
        <translation>Nie użyto tego, co zachowano do odzyskania: %1</translation>
    </message>
    <message>
        <source>Something else has been stored since; it stays as it is:</source>
        <translation>Od tego czasu zapisano coś innego; zostaje bez zmian:</translation>
    </message>
    <message>
        <source>Forget what was kept</source>
        <translation>Zapomnij, co zachowano</translation>
    </message>
    <message>
        <source>Another program is writing to the database; what was kept is offered again at the next start.</source>
        <translation>Inny program pisze do bazy; to, co zachowano, zostanie zaproponowane przy następnym uruchomieniu.</translation>
    </message>
    <message>
        <source>What could not be stored is kept, and stored as soon as the database is free.</source>
        <translation>To, czego nie udało się zapisać, zachowano; zostanie zapisane, gdy tylko baza będzie wolna.</translation>
    </message>
    <message numerus="yes">
        <source>The database is free again: %n were put in.</source>
        <translation>
            <numerusform>Baza jest znowu wolna: wstawiono %n.</numerusform>
            <numerusform>Baza jest znowu wolna: wstawiono %n.</numerusform>
            <numerusform>Baza jest znowu wolna: wstawiono %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>W&amp;stecz</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Dalej</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Y</source>
        <translation>Ctrl+Shift+Y</translation>
    </message>
    <message>
        <source>&amp;Larger text</source>
        <translation>&amp;Większy tekst</translation>
    </message>
    <message>
        <source>Smaller te&amp;xt</source>
        <translation>&amp;Mniejszy tekst</translation>
    </message>
    <message>
        <source>&amp;Usual text size</source>
        <translation>&amp;Zwykły rozmiar tekstu</translation>
    </message>
    <message>
        <source>Ctrl+Shift+0</source>
        <translation>Ctrl+Shift+0</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>P&amp;ełny ekran</translation>
    </message>
    <message>
        <source>Lubberline databases (*.lubberline *.db);;All files (*)</source>
        <translation>Bazy Lubberline (*.lubberline *.db);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drukuj…</translation>
    </message>
    <message>
        <source>New &amp;database…</source>
        <translation>&amp;Nowa baza danych…</translation>
    </message>
    <message>
        <source>New database</source>
        <translation>Nowa baza danych</translation>
    </message>
    <message>
        <source>&amp;Open a database…</source>
        <translation>&amp;Otwórz bazę danych…</translation>
    </message>
    <message>
        <source>Open a database</source>
        <translation>Otwieranie bazy danych</translation>
    </message>
    <message>
        <source>Back to &amp;your own database</source>
        <translation>Wróć do &amp;własnej bazy</translation>
    </message>
    <message>
        <source>De&amp;monstration fleet</source>
        <translation>Flota de&amp;monstracyjna</translation>
    </message>
    <message>
        <source>&amp;Save a copy of the database…</source>
        <translation>Zapisz &amp;kopię bazy…</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>Kopia zapasowa &amp;teraz</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U</source>
        <translation>Ctrl+Shift+U</translation>
    </message>
    <message>
        <source>R&amp;estore from a backup…</source>
        <translation>P&amp;rzywróć z kopii zapasowej…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Otwórz o&amp;statnie</translation>
    </message>
    <message>
        <source>no other database has been open</source>
        <translation>nie otwierano innej bazy</translation>
    </message>
    <message>
        <source>A file is being read or written. Wait for it, or cancel it.</source>
        <translation>Trwa odczyt lub zapis pliku. Poczekaj albo anuluj.</translation>
    </message>
    <message>
        <source>%1: there is a file of this name already. Open it, or choose a new name for the new database.</source>
        <translation>%1: plik o tej nazwie już istnieje. Otwórz go albo wybierz nową nazwę dla nowej bazy.</translation>
    </message>
    <message>
        <source>%1: nothing on this machine opens it.</source>
        <translation>%1: nic na tym komputerze go nie otwiera.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwarte</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Pokaż w folderze</translation>
    </message>
    <message>
        <source>Save a copy of the database</source>
        <translation>Zapisywanie kopii bazy</translation>
    </message>
    <message>
        <source>%1: the folder for backups is not there; choose another in the preferences.</source>
        <translation>%1: nie ma folderu na kopie zapasowe; wybierz inny w preferencjach.</translation>
    </message>
    <message>
        <source>Restore from a backup</source>
        <translation>Przywracanie z kopii zapasowej</translation>
    </message>
    <message>
        <source>Put %1 in the place of this database? What is here now is kept beside it under the name of this moment.</source>
        <translation>Umieścić %1 na miejscu tej bazy? To, co jest teraz, zostanie obok niej pod nazwą tej chwili.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Wy&amp;tnij</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiuj</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Wklej</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Zaznacz w&amp;szystko</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Znajdź…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
    <message>
        <source>%1: what was typed there was refused and is not stored: %2.</source>
        <translation>%1: to, co tam wpisano, zostało odrzucone i nie jest zapisane: %2.</translation>
    </message>
    <message>
        <source>%1 has been removed in another window or by another program.</source>
        <translation>%1 usunięto w innym oknie albo w innym programie.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Zapisywanie %1</translation>
    </message>
    <message>
        <source>The swing is made; %1.</source>
        <translation>Pomiar utworzono; %1.</translation>
    </message>
    <message>
        <source>The swing of %1 is signed and frozen: what was done to it before is not undone. Amend it in a new revision to change it.</source>
        <translation>Pomiar z %1 jest podpisany i zamrożony: wcześniejszych zmian już się nie cofa. Aby go zmienić, sporządzić poprawkę (nowe wydanie).</translation>
    </message>
    <message>
        <source>no stated date</source>
        <translation>niepodanej daty</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ManoeuvreLine</name>
    <message>
        <source>turn, °/s</source>
        <translation>zakręt, °/s</translation>
    </message>
    <message>
        <source>speed, m/s²</source>
        <translation>prędkość, m/s²</translation>
    </message>
    <message>
        <source>climb, m/s</source>
        <translation>wznoszenie, m/s</translation>
    </message>
    <message>
        <source>Time line of manoeuvres</source>
        <translation>Oś czasu manewrów</translation>
    </message>
    <message>
        <source>Draw a block in a lane: right of north, faster and up are above the line. Drag it to move or raise it, its ends to stretch it. Keys: Insert, Page Up and Down, arrows, Shift with arrows, Delete.</source>
        <translation>Narysuj blok na torze: w prawo, szybciej i w górę są nad linią. Przeciągnij go, by przesunąć lub podnieść, jego końce, by rozciągnąć. Klawisze: Insert, Page Up i Down, strzałki, Shift ze strzałkami, Delete.</translation>
    </message>
    <message>
        <source>%1 to %2 s: %3 %4</source>
        <translation>od %1 do %2 s: %3 %4</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::MapChart</name>
    <message>
        <source>contours</source>
        <translation>warstwice</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>dopuszczalne</translation>
    </message>
    <message>
        <source>extremes ▲▼</source>
        <translation>ekstrema ▲▼</translation>
    </message>
    <message>
        <source>There is no map yet.</source>
        <translation>Mapy jeszcze nie ma.</translation>
    </message>
    <message>
        <source>limit ±%1°</source>
        <translation>dopuszczalne ±%1°</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::MapControls</name>
    <message>
        <source>the angle that is held</source>
        <translation>kąt utrzymywany stale</translation>
    </message>
    <message>
        <source>Axes of the map</source>
        <translation>Osie mapy</translation>
    </message>
    <message>
        <source>heading × pitch, roll held</source>
        <translation>kurs × pochylenie, stałe przechylenie</translation>
    </message>
    <message>
        <source>heading × roll, pitch held</source>
        <translation>kurs × przechylenie, stałe pochylenie</translation>
    </message>
    <message>
        <source>pitch × roll, heading held</source>
        <translation>pochylenie × przechylenie, stały kurs</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Porównaj z</translation>
    </message>
    <message>
        <source>Which of the two is shown</source>
        <translation>Który z dwóch jest pokazany</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>różnica</translation>
    </message>
    <message>
        <source>this model</source>
        <translation>ten model</translation>
    </message>
    <message>
        <source>the other</source>
        <translation>drugi</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>&amp;Eksportuj…</translation>
    </message>
    <message>
        <source>&amp;compare with</source>
        <translation>po&amp;równaj z</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 wył.</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 wł.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::MapPlot</name>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::MapText</name>
    <message>
        <source>heading</source>
        <translation>kurs</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>pochylenie</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>przechylenie</translation>
    </message>
    <message>
        <source>magnetic heading (°)</source>
        <translation>kurs magnetyczny (°)</translation>
    </message>
    <message>
        <source>pitch (°, nose up +)</source>
        <translation>pochylenie (°, nos w górę +)</translation>
    </message>
    <message>
        <source>roll (°, starboard down +)</source>
        <translation>przechylenie (°, w prawo +)</translation>
    </message>
    <message>
        <source>MEASURED</source>
        <translation>ZMIERZONA</translation>
    </message>
    <message>
        <source>MODELLED</source>
        <translation>Z MODELU</translation>
    </message>
    <message>
        <source>difference of deviations (°, east +)</source>
        <translation>różnica dewiacji (°, wschodnia +)</translation>
    </message>
    <message>
        <source>deviation (°, east +)</source>
        <translation>dewiacja (°, wschodnia +)</translation>
    </message>
    <message>
        <source>horizontal field vanishes</source>
        <translation>pole poziome zanika</translation>
    </message>
    <message>
        <source>difference %1</source>
        <translation>różnica %1</translation>
    </message>
    <message>
        <source>deviation %1</source>
        <translation>dewiacja %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1 ± %2° (95 %, by its calibration)</source>
        <translation>%1 ± %2° (95 %, według kalibracji)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::MessagePanel</name>
    <message>
        <source>Close (Esc)</source>
        <translation>Zamknij (Esc)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Zamknij ten komunikat</translation>
    </message>
    <message>
        <source>failure</source>
        <translation>błąd</translation>
    </message>
    <message>
        <source>news</source>
        <translation>wiadomość</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>jeszcze %n</numerusform>
            <numerusform>jeszcze %n</numerusform>
            <numerusform>jeszcze %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lubberline::ui::NamingStrip</name>
    <message>
        <source>registration</source>
        <translation>znaki rejestracyjne</translation>
    </message>
    <message>
        <source>type</source>
        <translation>typ</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importuj</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Whose swing is %1?</source>
        <translation>Czyj jest pomiar %1?</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::NewRecordPage</name>
    <message>
        <source>New type of aircraft</source>
        <translation>Nowy typ statku powietrznego</translation>
    </message>
    <message>
        <source>New aircraft</source>
        <translation>Nowy statek powietrzny</translation>
    </message>
    <message>
        <source>New compass</source>
        <translation>Nowa busola</translation>
    </message>
    <message>
        <source>&amp;Make it</source>
        <translation>&amp;Utwórz</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nazwa:</translation>
    </message>
    <message>
        <source>Ma&amp;ker:</source>
        <translation>&amp;Producent:</translation>
    </message>
    <message>
        <source>as Su-22</source>
        <translation>jak Su-22</translation>
    </message>
    <message>
        <source>&amp;Type:</source>
        <translation>&amp;Typ:</translation>
    </message>
    <message>
        <source>&amp;Registration:</source>
        <translation>&amp;Znaki rejestracyjne:</translation>
    </message>
    <message>
        <source>registration or tail number</source>
        <translation>znaki rejestracyjne lub numer boczny</translation>
    </message>
    <message>
        <source>&amp;Aircraft:</source>
        <translation>&amp;Statek powietrzny:</translation>
    </message>
    <message>
        <source>&amp;Limits:</source>
        <translation>&amp;Dopuszczalne:</translation>
    </message>
    <message>
        <source>as standby compass</source>
        <translation>na przykład busola zapasowa</translation>
    </message>
    <message>
        <source>none set</source>
        <translation>nie ustalono</translation>
    </message>
    <message>
        <source>Name the aircraft by its registration or tail number.</source>
        <translation>Podaj znaki rejestracyjne lub numer boczny statku powietrznego.</translation>
    </message>
    <message>
        <source>A name is expected.</source>
        <translation>Oczekiwano nazwy.</translation>
    </message>
    <message>
        <source>There is no type of aircraft yet: make one first (menu Fleet, New type)</source>
        <translation>Nie ma jeszcze typu statku powietrznego: najpierw go utwórz (menu Flota, Nowy typ)</translation>
    </message>
    <message>
        <source>There is no aircraft yet: make one first (menu Fleet, New aircraft)</source>
        <translation>Nie ma jeszcze statku powietrznego: najpierw go utwórz (menu Flota, Nowy statek)</translation>
    </message>
    <message>
        <source>new type %1</source>
        <translation>nowy typ %1</translation>
    </message>
    <message>
        <source>new aircraft %1</source>
        <translation>nowy statek powietrzny %1</translation>
    </message>
    <message>
        <source>new compass %1</source>
        <translation>nowa busola %1</translation>
    </message>
    <message>
        <source>New &amp;type…</source>
        <translation>Nowy &amp;typ…</translation>
    </message>
    <message>
        <source>New &amp;aircraft…</source>
        <translation>Nowy &amp;statek powietrzny…</translation>
    </message>
    <message>
        <source>New &amp;compass…</source>
        <translation>Nowa &amp;busola…</translation>
    </message>
    <message>
        <source>Asks for what a new type, aircraft or compass must have; all else is filled in on its own page afterwards. It can be undone with Ctrl+Z.</source>
        <translation>Pyta o to, co musi mieć nowy typ, statek powietrzny lub busola; resztę wypełnia się potem na jego stronie. Można to cofnąć przez Ctrl+Z.</translation>
    </message>
    <message>
        <source>removal of %1</source>
        <translation>usunięcie %1</translation>
    </message>
    <message>
        <source>%1 was removed, with all that belongs to it. Ctrl+Z puts it back.</source>
        <translation>Usunięto %1 ze wszystkim, co do niego należy. Ctrl+Z przywraca.</translation>
    </message>
    <message>
        <source>Remove this t&amp;ype</source>
        <translation>Usuń ten t&amp;yp</translation>
    </message>
    <message>
        <source>Remove this a&amp;ircraft</source>
        <translation>Usuń ten st&amp;atek</translation>
    </message>
    <message>
        <source>Remove this compa&amp;ss</source>
        <translation>Usuń tę bus&amp;olę</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::NewSwingPage</name>
    <message>
        <source>&amp;New swing</source>
        <translation>&amp;Nowy pomiar dewiacji</translation>
    </message>
    <message>
        <source>pick or type, as Su-22</source>
        <translation>wybierz lub wpisz, na przykład Su-22</translation>
    </message>
    <message>
        <source>registration or tail number</source>
        <translation>znaki rejestracyjne lub numer boczny</translation>
    </message>
    <message>
        <source>as standby compass</source>
        <translation>na przykład busola zapasowa</translation>
    </message>
    <message>
        <source>compass base; may stay empty</source>
        <translation>krąg dewiacyjny; może pozostać puste</translation>
    </message>
    <message>
        <source>&amp;Start entering readings</source>
        <translation>&amp;Zacznij wpisywać odczyty</translation>
    </message>
    <message>
        <source>What a new compass is held against. A known compass keeps its own: see the aircraft&apos;s page</source>
        <translation>Względem czego oceniana jest nowa busola. Znana busola zachowuje swoje wartości: zob. stronę statku powietrznego</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>New swing</source>
        <translation>Nowy pomiar</translation>
    </message>
    <message>
        <source>&amp;Type:</source>
        <translation>&amp;Typ:</translation>
    </message>
    <message>
        <source>&amp;Aircraft:</source>
        <translation>&amp;Statek powietrzny:</translation>
    </message>
    <message>
        <source>&amp;Compass:</source>
        <translation>&amp;Busola:</translation>
    </message>
    <message>
        <source>&amp;Limits:</source>
        <translation>&amp;Dopuszczalne:</translation>
    </message>
    <message>
        <source>S&amp;ite:</source>
        <translation>&amp;Miejsce:</translation>
    </message>
    <message>
        <source>&amp;Date (UTC):</source>
        <translation>D&amp;ata (UTC):</translation>
    </message>
    <message>
        <source>&amp;Kind:</source>
        <translation>&amp;Rodzaj:</translation>
    </message>
    <message>
        <source>Sta&amp;ge:</source>
        <translation>&amp;Etap:</translation>
    </message>
    <message>
        <source>none set</source>
        <translation>nie ustalono</translation>
    </message>
    <message>
        <source>Name the type of the aircraft.</source>
        <translation>Podaj typ statku powietrznego.</translation>
    </message>
    <message>
        <source>Name the aircraft by its registration or tail number.</source>
        <translation>Podaj znaki rejestracyjne lub numer boczny statku powietrznego.</translation>
    </message>
    <message>
        <source>Name the compass that is swung.</source>
        <translation>Podaj busolę, której dewiacja jest mierzona.</translation>
    </message>
    <message>
        <source>new swing</source>
        <translation>nowy pomiar dewiacji</translation>
    </message>
    <message>
        <source>The swing was not stored.</source>
        <translation>Pomiaru nie zapisano.</translation>
    </message>
    <message>
        <source>Pick the aircraft and its compass, or type new ones; Enter goes on to the next field. The readings are typed on the page that follows.</source>
        <translation>Wybierz statek powietrzny i jego busolę albo wpisz nowe; Enter przechodzi do następnego pola. Odczyty wpisuje się na następnej stronie.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::NmeaImportPage</name>
    <message>
        <source>Swing from an &amp;NMEA log…</source>
        <translation>Pomiar z zapisu &amp;NMEA…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not allowed for %2; expected a number from 0 on</source>
        <translation>„%1” jest niedozwolone dla: %2; oczekiwano liczby od 0</translation>
    </message>
    <message>
        <source>log</source>
        <translation>zapis</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>%1 pairs of headings, %2 used; %3 slower than %4 kt, %5 in a turn faster than %6°/s</source>
        <translation>par kursów: %1, użyto %2; %3 wolniej niż %4 kt, %5 w zakręcie szybszym niż %6°/s</translation>
    </message>
    <message>
        <source>, %1 left out for another cause (see below)</source>
        <translation>, %1 pominięto z innej przyczyny (zob. niżej)</translation>
    </message>
    <message>
        <source>&amp;Open a log…</source>
        <translation>&amp;Otwórz zapis…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>&amp;Make a swing of it</source>
        <translation>Utwórz &amp;z niego pomiar</translation>
    </message>
    <message>
        <source>empty: the log&apos;s, else the model&apos;s; log; model; or degrees, E +</source>
        <translation>puste: z zapisu, inaczej z modelu; log; model; albo stopnie, E +</translation>
    </message>
    <message>
        <source>as HC; empty: the only one</source>
        <translation>np. HC; puste: jedyny</translation>
    </message>
    <message>
        <source>&amp;Reference:</source>
        <translation>&amp;Odniesienie:</translation>
    </message>
    <message>
        <source>&amp;Variation:</source>
        <translation>&amp;Deklinacja:</translation>
    </message>
    <message>
        <source>&amp;Slowest used (kt):</source>
        <translation>Najwolniej &amp;użyte (kt):</translation>
    </message>
    <message>
        <source>&amp;Fastest turn used (°/s):</source>
        <translation>Najszybszy użyty &amp;zakręt (°/s):</translation>
    </message>
    <message>
        <source>Compass &amp;talker:</source>
        <translation>&amp;Nadajnik busoli:</translation>
    </message>
    <message>
        <source>&amp;Kind of swing:</source>
        <translation>Rodzaj p&amp;omiaru:</translation>
    </message>
    <message>
        <source>A log of a slow turn as a swing of %1 · %2</source>
        <translation>Zapis powolnego zakrętu jako pomiar %1 · %2</translation>
    </message>
    <message>
        <source>Open a log</source>
        <translation>Otwieranie zapisu</translation>
    </message>
    <message>
        <source>NMEA 0183 logs (*.nmea *.log *.txt);;All files (*)</source>
        <translation>Zapisy NMEA 0183 (*.nmea *.log *.txt);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>the slowest speed</source>
        <translation>najmniejsza prędkość</translation>
    </message>
    <message>
        <source>the fastest turn</source>
        <translation>najszybszy zakręt</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Czytanie %1 …</translation>
    </message>
    <message>
        <source>%1: %2 sentences, %3 with a wrong checksum, %4 lines that are none.</source>
        <translation>%1: zdań %2, z błędną sumą kontrolną %3, wierszy niebędących zdaniami %4.</translation>
    </message>
    <message>
        <source>Variation %1° (E +): %2.</source>
        <translation>Deklinacja %1° (E +): %2.</translation>
    </message>
    <message>
        <source>taken out in flight</source>
        <translation>usuwany w locie</translation>
    </message>
    <message>
        <source>taken out always (afloat)</source>
        <translation>usuwany zawsze (na wodzie)</translation>
    </message>
    <message>
        <source>none (on wheels)</source>
        <translation>brak (na kołach)</translation>
    </message>
    <message>
        <source>standard error, where you know of one: survey, magnetic storm</source>
        <translation>błąd standardowy, jeśli jest znany: pomiar, burza magnetyczna</translation>
    </message>
    <message>
        <source>YYYY-MM-DD, where the log&apos;s own is wrong</source>
        <translation>RRRR-MM-DD, gdy data zapisu jest błędna</translation>
    </message>
    <message>
        <source>&amp;Wind on a track:</source>
        <translation>W&amp;iatr na kącie drogi:</translation>
    </message>
    <message>
        <source>Variation sure to (°):</source>
        <translation>Deklinacja pewna do (°):</translation>
    </message>
    <message>
        <source>&amp;Date of the log:</source>
        <translation>D&amp;ata zapisu:</translation>
    </message>
    <message>
        <source>how sure the variation is</source>
        <translation>pewność deklinacji</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no date; expected YYYY-MM-DD</source>
        <translation>„%1” nie jest datą; oczekiwano RRRR-MM-DD</translation>
    </message>
    <message>
        <source>Open a log of a slow turn through all headings: what of it is used, what is cut off and why, and the curve that it gives. Say what the compass is held against, and the variation where the log has none; then make a swing of it.</source>
        <translation>Otwórz zapis powolnego zakrętu przez wszystkie kursy: co z niego użyto, co odcięto i dlaczego, oraz wynikająca krzywa. Podaj, z czym porównuje się busolę, i deklinację, gdy zapis jej nie ma; potem utwórz z niego pomiar.</translation>
    </message>
    <message>
        <source>A log of a slow turn as a swing</source>
        <translation>Zapis powolnego zakrętu jako pomiar</translation>
    </message>
    <message>
        <source>Open a log: what was read on each heading is drawn here.</source>
        <translation>Otwórz dziennik: tu zostanie narysowane, co odczytano na każdym kursie.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::OpenSwings</name>
    <message>
        <source>a step that does not read</source>
        <translation>kroku, który nie czyta</translation>
    </message>
    <message>
        <source>its preparation</source>
        <translation>przygotowaniu</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>kroku %1 z %2</translation>
    </message>
    <message>
        <source>its index</source>
        <translation>indeksie</translation>
    </message>
    <message>
        <source>its review</source>
        <translation>przeglądzie odczytów</translation>
    </message>
    <message>
        <source>a fault (%1)</source>
        <translation>usterce (%1)</translation>
    </message>
    <message>
        <source>its end: abandoned, %1</source>
        <translation>końcu: przerwany, %1</translation>
    </message>
    <message>
        <source>%1 %2 stands at %3: go on</source>
        <translation>%1 %2 stoi na %3: kontynuuj</translation>
    </message>
    <message>
        <source>Guided swing abandoned: %1</source>
        <translation>Pomiar prowadzony przerwany: %1</translation>
    </message>
    <message>
        <source>NOT SIGNED (no signatures stand)</source>
        <translation>NIEPODPISANY (żaden podpis nie obowiązuje)</translation>
    </message>
    <message>
        <source>%1 (not checked)</source>
        <translation>%1 (niesprawdzone)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::OverviewPage</name>
    <message>
        <source>no date</source>
        <translation>brak daty</translation>
    </message>
    <message>
        <source>&amp;Overview</source>
        <translation>&amp;Przegląd</translation>
    </message>
    <message>
        <source>Alt+Home</source>
        <translation>Alt+Home</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Statek powietrzny</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Start a new swing</source>
        <translation>Zacznij nowy pomiar dewiacji</translation>
    </message>
    <message>
        <source>Import a file</source>
        <translation>Wczytaj plik</translation>
    </message>
    <message>
        <source>Choose an aircraft in the tree at the left, open its compass, and pick a swing. The state of an aircraft is that of the newest swing of its compasses, held against the limits set for each.</source>
        <translation>Wybierz statek powietrzny w drzewie po lewej, rozwiń jego busolę i wskaż pomiar. Stan statku powietrznego wynika z najnowszych pomiarów jego busol, odniesionych do ustalonych dla nich wartości dopuszczalnych.</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Flota</translation>
    </message>
    <message>
        <source>types: %1 · aircraft: %2 · compasses: %3 · swings: %4</source>
        <translation>typy: %1 · statki powietrzne: %2 · busole: %3 · pomiary: %4</translation>
    </message>
    <message>
        <source>No aircraft is out of limits.</source>
        <translation>Żaden statek powietrzny nie przekracza wartości dopuszczalnych.</translation>
    </message>
    <message>
        <source>Out of limits: %1 aircraft</source>
        <translation>Poza granicami, statki powietrzne: %1</translation>
    </message>
    <message>
        <source>aircraft: %1</source>
        <translation>statki powietrzne: %1</translation>
    </message>
    <message>
        <source>All aircraft of this type</source>
        <translation>Wszystkie statki powietrzne tego typu</translation>
    </message>
    <message>
        <source>What needs a hand today comes first: guided swings that stand half-way, compasses that are due or out of limits, the newest swings; Enter or a click goes there. Beneath it the aircraft that are out of limits: their state is that of the newest swing of each compass, held against its limits. Ctrl+F finds one by name.</source>
        <translation>Najpierw to, co dziś wymaga ręki: pomiary prowadzone stojące w połowie, busole z należnym pomiarem lub poza granicami, najnowsze pomiary; Enter lub kliknięcie tam prowadzi. Poniżej statki powietrzne poza granicami: ich stan to stan najnowszego pomiaru każdej busoli wobec jej wartości dopuszczalnych. Ctrl+F znajduje po nazwie.</translation>
    </message>
    <message>
        <source>What needs a hand today</source>
        <translation>Co dziś wymaga ręki</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Dziś</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Busola</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Dlaczego</translation>
    </message>
    <message>
        <source>due</source>
        <translation>wymagany</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole list</source>
        <translation>cały wykaz</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>kontynuuj</translation>
    </message>
    <message>
        <source>swung</source>
        <translation>zmierzono</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ParameterCell</name>
    <message>
        <source>%1
Arrow keys, or Shift while dragging: fine steps; page keys: coarse ones; double click: back to zero</source>
        <translation>%1
Strzałki albo Shift przy przeciąganiu: drobne kroki; Page Up i Down: grube; dwuklik: powrót do zera</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PlaceText</name>
    <message>
        <source>“%1” is no latitude; expected 90 S to 90 N, as 51.55 N, 51°33&apos;N or -33.9</source>
        <translation>„%1” nie jest szerokością geograficzną; oczekiwano od 90 S do 90 N, np. 51.55 N, 51°33&apos;N lub -33.9</translation>
    </message>
    <message>
        <source>“%1” is no longitude; expected degrees, east positive, as 21.89 E, 21°53&apos;E or -70.67</source>
        <translation>„%1” nie jest długością geograficzną; oczekiwano stopni, wschodnia dodatnia, np. 21.89 E, 21°53&apos;E lub -70.67</translation>
    </message>
    <message>
        <source>“%1” is no height; expected metres, as 118</source>
        <translation>„%1” nie jest wysokością; oczekiwano metrów, np. 118</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Plot</name>
    <message>
        <source>Export the plot</source>
        <translation>Eksportuj wykres</translation>
    </message>
    <message>
        <source>Image (*.png);;Drawing (*.svg);;PDF (*.pdf)</source>
        <translation>Obraz (*.png);;Rysunek (*.svg);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>P&amp;rzywróć skalę</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiuj</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Eksportuj…</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PlotFile</name>
    <message>
        <source>a plot can be written as .png, .svg or .pdf, not as &quot;%1&quot;</source>
        <translation>wykres można zapisać jako .png, .svg lub .pdf, nie jako „%1”</translation>
    </message>
    <message>
        <source>a plot needs a width and a height of at least 1 pixel</source>
        <translation>wykres musi mieć szerokość i wysokość co najmniej 1 piksela</translation>
    </message>
    <message>
        <source>no font is installed, so the plot would have no text; install one (fonts-dejavu-core)</source>
        <translation>nie zainstalowano czcionki, więc wykres nie miałby opisów; zainstaluj ją (fonts-dejavu-core)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PlotLegend</name>
    <message>
        <source>Click to hide</source>
        <translation>Kliknij, aby ukryć</translation>
    </message>
    <message>
        <source>Click to show</source>
        <translation>Kliknij, aby pokazać</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PlotTabs</name>
    <message>
        <source>&amp;Polar</source>
        <translation>&amp;Biegunowy</translation>
    </message>
    <message>
        <source>C&amp;urve</source>
        <translation>&amp;Krzywa</translation>
    </message>
    <message>
        <source>Spectru&amp;m</source>
        <translation>&amp;Widmo</translation>
    </message>
    <message>
        <source>C&amp;omponents</source>
        <translation>&amp;Składowe</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Plots</name>
    <message>
        <source>%1 t = %2</source>
        <translation>%1 t = %2</translation>
    </message>
    <message>
        <source>magnetic %1</source>
        <translation>magnetyczny %1</translation>
    </message>
    <message>
        <source>compass %1</source>
        <translation>kompasowy %1</translation>
    </message>
    <message>
        <source>deviation %1</source>
        <translation>dewiacja %1</translation>
    </message>
    <message>
        <source>residual %1</source>
        <translation>reszta %1</translation>
    </message>
    <message>
        <source>t = %1</source>
        <translation>t = %1</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>wątpliwy</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>pominięty</translation>
    </message>
    <message>
        <source>exact fit %1</source>
        <translation>dopasowanie dokładne %1</translation>
    </message>
    <message>
        <source>sum %1</source>
        <translation>suma %1</translation>
    </message>
    <message>
        <source>order %1</source>
        <translation>rząd %1</translation>
    </message>
    <message>
        <source>order %1 (%2)</source>
        <translation>rząd %1 (%2)</translation>
    </message>
    <message>
        <source>not resolved by these headings (highest order: %1)</source>
        <translation>te kursy go nie rozróżniają (najwyższy rząd: %1)</translation>
    </message>
    <message>
        <source>amplitude %1°</source>
        <translation>amplituda %1°</translation>
    </message>
    <message>
        <source>only its cosine can be told (order = half the number of headings)</source>
        <translation>można określić tylko jego cosinus (rząd = połowa liczby kursów)</translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation>faza %1</translation>
    </message>
    <message>
        <source>Enter readings: a magnetic and a compass heading in each row.
Three headings give a first result.</source>
        <translation>Wpisz odczyty: kurs magnetyczny i kurs kompasowy w każdym wierszu.
Trzy kursy dają pierwszy wynik.</translation>
    </message>
    <message>
        <source>deviation (°)
outward = east (+)</source>
        <translation>dewiacja (°)
na zewnątrz = wschodnia (+)</translation>
    </message>
    <message>
        <source>magnetic
heading (°)</source>
        <translation>kurs
magnetyczny (°)</translation>
    </message>
    <message>
        <source>deviation (°, east +)</source>
        <translation>dewiacja (°, wschodnia +)</translation>
    </message>
    <message>
        <source>magnetic heading (°)</source>
        <translation>kurs magnetyczny (°)</translation>
    </message>
    <message>
        <source>previous swing</source>
        <translation>poprzedni pomiar</translation>
    </message>
    <message>
        <source>previous swing (%1)</source>
        <translation>poprzedni pomiar (%1)</translation>
    </message>
    <message>
        <source>limit ±%1°</source>
        <translation>dopuszczalne ±%1°</translation>
    </message>
    <message>
        <source>, beyond this scale</source>
        <translation>, poza tą skalą</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PolarChart</name>
    <message>
        <source>previous swing</source>
        <translation>poprzedni pomiar</translation>
    </message>
    <message>
        <source>approximate fit</source>
        <translation>dopasowanie przybliżone</translation>
    </message>
    <message>
        <source>exact fit</source>
        <translation>dopasowanie dokładne</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>odczyty</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>dopuszczalne</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PopulationFilters</name>
    <message>
        <source>%1: &apos;%2&apos; is no day of the calendar; expected YYYY-MM-DD</source>
        <translation>%1: &apos;%2&apos; nie jest dniem kalendarza; oczekiwano RRRR-MM-DD</translation>
    </message>
    <message>
        <source>Aircraft type</source>
        <translation>Typ statku powietrznego</translation>
    </message>
    <message>
        <source>Compass system; those of the swings that were computed last are offered</source>
        <translation>Układ busoli; dostępne są te z ostatnio obliczonych pomiarów</translation>
    </message>
    <message>
        <source>Where they were swung</source>
        <translation>Gdzie je mierzono</translation>
    </message>
    <message>
        <source>Where the aircraft are based now</source>
        <translation>Gdzie statki powietrzne teraz bazują</translation>
    </message>
    <message>
        <source>Of pattern, coefficients and bases; pairs and histories need both</source>
        <translation>Wzoru, współczynników i baz; pary i historie potrzebują obu</translation>
    </message>
    <message>
        <source>found and left</source>
        <translation>zastane i pozostawione</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>stan zastany</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>stan końcowy</translation>
    </message>
    <message>
        <source>all types</source>
        <translation>wszystkie typy</translation>
    </message>
    <message>
        <source>swung anywhere</source>
        <translation>mierzone gdziekolwiek</translation>
    </message>
    <message>
        <source>based anywhere</source>
        <translation>bazujące gdziekolwiek</translation>
    </message>
    <message>
        <source>all compass systems</source>
        <translation>wszystkie układy busoli</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>training</source>
        <translation>szkolenie</translation>
    </message>
    <message>
        <source>any radio state</source>
        <translation>dowolny stan radia</translation>
    </message>
    <message>
        <source>radio on</source>
        <translation>radio włączone</translation>
    </message>
    <message>
        <source>radio off</source>
        <translation>radio wyłączone</translation>
    </message>
    <message>
        <source>one aircraft, one vote</source>
        <translation>jeden statek powietrzny, jeden głos</translation>
    </message>
    <message>
        <source>one swing, one vote</source>
        <translation>jeden pomiar, jeden głos</translation>
    </message>
    <message>
        <source>State of the radio</source>
        <translation>Stan radia</translation>
    </message>
    <message>
        <source>Who has a say in the mean</source>
        <translation>Kto ma głos w średniej</translation>
    </message>
    <message>
        <source>From this day on, YYYY-MM-DD</source>
        <translation>Od tego dnia, RRRR-MM-DD</translation>
    </message>
    <message>
        <source>Up to this day, YYYY-MM-DD</source>
        <translation>Do tego dnia, RRRR-MM-DD</translation>
    </message>
    <message>
        <source>A day to compare |A| before and after, as that of a training, YYYY-MM-DD; empty: the data are asked for one</source>
        <translation>Dzień, przed którym i po którym porównuje się |A|, na przykład szkolenia, RRRR-MM-DD; puste: szuka się go w danych</translation>
    </message>
    <message>
        <source> headings</source>
        <translation> kursów</translation>
    </message>
    <message>
        <source>Period:</source>
        <translation>Okres:</translation>
    </message>
    <message>
        <source>Training:</source>
        <translation>Szkolenie:</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PopulationPage</name>
    <message>
        <source>Years of swings of a type looked at together: choose a type, then Compute. A click on a heading of the plot lists the swings behind it; the other tabs tell which compass to swing next, the history of one compass as a film, and the tables of the report.</source>
        <translation>Lata pomiarów jednego typu oglądane razem: wybierz typ, potem Oblicz. Kliknięcie kursu na wykresie wymienia pomiary, które za nim stoją; inne karty mówią, którą busolę mierzyć następną, pokazują historię jednej busoli jak film oraz tabele raportu.</translation>
    </message>
    <message>
        <source>Save the fleet &amp;report…</source>
        <translation>Zapisz &amp;raport o flocie…</translation>
    </message>
    <message>
        <source>Years as a po&amp;pulation</source>
        <translation>Lata jako po&amp;pulacja</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Oblicz</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>&amp;Anuluj</translation>
    </message>
    <message>
        <source>&amp;Save the report…</source>
        <translation>&amp;Zapisz raport…</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Wzorzec</translation>
    </message>
    <message>
        <source>Who next</source>
        <translation>Kto następny</translation>
    </message>
    <message>
        <source>History of a compass</source>
        <translation>Historia busoli</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabele</translation>
    </message>
    <message>
        <source>Years as a population</source>
        <translation>Lata jako populacja</translation>
    </message>
    <message>
        <source>date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>aircraft</source>
        <translation>statek powietrzny</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>dewiacja</translation>
    </message>
    <message>
        <source>how</source>
        <translation>jak</translation>
    </message>
    <message>
        <source>Click a heading: the swings behind it stand here.</source>
        <translation>Kliknij kurs: tu pojawią się pomiary, które za nim stoją.</translation>
    </message>
    <message>
        <source>The fleet has changed since: compute again.</source>
        <translation>Flota zmieniła się od tego czasu: oblicz ponownie.</translation>
    </message>
    <message>
        <source>All swings are read and computed…</source>
        <translation>Wszystkie pomiary są wczytywane i obliczane…</translation>
    </message>
    <message>
        <source>Cancelled: what was computed before stays.</source>
        <translation>Anulowano: pozostaje to, co obliczono wcześniej.</translation>
    </message>
    <message>
        <source>Coefficients</source>
        <translation>Współczynniki</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmoniczne</translation>
    </message>
    <message>
        <source>Exceedance</source>
        <translation>Przekroczenia</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Składowe</translation>
    </message>
    <message>
        <source>Bases and crews</source>
        <translation>Bazy i załogi</translation>
    </message>
    <message>
        <source>Jumps</source>
        <translation>Skoki</translation>
    </message>
    <message>
        <source>Drifts</source>
        <translation>Dryfy</translation>
    </message>
    <message>
        <source>Bins</source>
        <translation>Przedziały</translation>
    </message>
    <message>
        <source>read</source>
        <translation>odczytana</translation>
    </message>
    <message>
        <source>by its own curve</source>
        <translation>z własnej krzywej</translation>
    </message>
    <message>
        <source>Save the fleet report</source>
        <translation>Zapisywanie raportu o flocie</translation>
    </message>
    <message>
        <source>Report (*.pdf);;Page (*.html);;Tables (*.csv);;Figures (*.json)</source>
        <translation>Raport (*.pdf);;Strona (*.html);;Tabele (*.csv);;Liczby (*.json)</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Rozkłady</translation>
    </message>
    <message>
        <source>Computing a first look at a part of the swings; all of them follow…</source>
        <translation>Trwa obliczanie z części pomiarów; wszystkie nastąpią…</translation>
    </message>
    <message>
        <source>Soft iron</source>
        <translation>Żelazo miękkie</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message numerus="yes">
        <source>%1°: mean %2°, between aircraft ± %3° (one standard deviation), %n vote(s)</source>
        <translation>
            <numerusform>%1°: średnia %2°, między samolotami ± %3° (odchylenie standardowe), %n głos</numerusform>
            <numerusform>%1°: średnia %2°, między samolotami ± %3° (odchylenie standardowe), %n głosy</numerusform>
            <numerusform>%1°: średnia %2°, między samolotami ± %3° (odchylenie standardowe), %n głosów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) of %1 aircraft.</source>
        <translation>
            <numerusform>%n dewiacja; statków powietrznych: %1.</numerusform>
            <numerusform>%n dewiacje; statków powietrznych: %1.</numerusform>
            <numerusform>%n dewiacji; statków powietrznych: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A first look at %n swing(s); all are being computed. </source>
        <translation>
            <numerusform>Pierwsze spojrzenie na %n dewiację; obliczane są wszystkie. </numerusform>
            <numerusform>Pierwsze spojrzenie na %n dewiacje; obliczane są wszystkie. </numerusform>
            <numerusform>Pierwsze spojrzenie na %n dewiacji; obliczane są wszystkie. </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) at %1°, those farthest from the mean first; Enter opens one.</source>
        <translation>
            <numerusform>%n dewiacja na %1°, najpierw najdalsze od średniej; Enter otwiera.</numerusform>
            <numerusform>%n dewiacje na %1°, najpierw najdalsze od średniej; Enter otwiera.</numerusform>
            <numerusform>%n dewiacji na %1°, najpierw najdalsze od średniej; Enter otwiera.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PredictionChart</name>
    <message>
        <source>possible</source>
        <translation>możliwa</translation>
    </message>
    <message>
        <source>magnetic heading (°)</source>
        <translation>kurs magnetyczny (°)</translation>
    </message>
    <message>
        <source>deviation (°, east +)</source>
        <translation>dewiacja (°, wschodnia +)</translation>
    </message>
    <message>
        <source>here</source>
        <translation>tutaj</translation>
    </message>
    <message>
        <source>there</source>
        <translation>tam</translation>
    </message>
    <message>
        <source>expected there</source>
        <translation>oczekiwana tam</translation>
    </message>
    <message>
        <source>possible there</source>
        <translation>możliwa tam</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>dopuszczalne</translation>
    </message>
    <message>
        <source>limit ±%1°</source>
        <translation>dopuszczalne ±%1°</translation>
    </message>
    <message>
        <source>magnetic %1</source>
        <translation>magnetyczny %1</translation>
    </message>
    <message>
        <source> · the horizontal field vanishes</source>
        <translation> · pole poziome zanika</translation>
    </message>
    <message>
        <source> · there %1</source>
        <translation> · tam %1</translation>
    </message>
    <message>
        <source> (%1 … %2)</source>
        <translation> (%1 … %2)</translation>
    </message>
    <message>
        <source> · here %1</source>
        <translation> · tutaj %1</translation>
    </message>
    <message>
        <source>possible there: %1 % if c, f ~ %2; P, Q ~ %3 nT; magnets ~ %4 nT</source>
        <translation>możliwa tam: %1 %, jeśli c, f ~ %2; P, Q ~ %3 nT; magnesy ~ %4 nT</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PredictionPage</name>
    <message>
        <source>What it will read at another &amp;base</source>
        <translation>Co wskaże w innej &amp;bazie</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Up to %1° expected</source>
        <translation>Oczekiwane do %1°</translation>
    </message>
    <message>
        <source>● In limits. %1; allowed %2°.</source>
        <translation>● W granicach. %1; dopuszczalne %2°.</translation>
    </message>
    <message>
        <source>▲ May leave its limits. %1; allowed %2°.</source>
        <translation>▲ Może przekroczyć granice. %1; dopuszczalne %2°.</translation>
    </message>
    <message>
        <source>▲ OUT OF LIMITS. %1; allowed %2°.</source>
        <translation>▲ POZA GRANICAMI. %1; dopuszczalne %2°.</translation>
    </message>
    <message>
        <source>○ %1; no limits are set for this compass.</source>
        <translation>○ %1; dla tej busoli nie ustalono granic.</translation>
    </message>
    <message>
        <source>Choose a swing, then the base that the aircraft moves to.</source>
        <translation>Wybierz pomiar, potem bazę, do której przenosi się statek powietrzny.</translation>
    </message>
    <message>
        <source>all its swings at different places</source>
        <translation>wszystkie jej pomiary w różnych miejscach</translation>
    </message>
    <message>
        <source>&amp;From:</source>
        <translation>&amp;Z:</translation>
    </message>
    <message>
        <source>&amp;Base:</source>
        <translation>&amp;Baza:</translation>
    </message>
    <message>
        <source>&amp;Latitude:</source>
        <translation>&amp;Szerokość geogr.:</translation>
    </message>
    <message>
        <source>L&amp;ongitude:</source>
        <translation>&amp;Długość geogr.:</translation>
    </message>
    <message>
        <source>&amp;Date:</source>
        <translation>D&amp;ata:</translation>
    </message>
    <message>
        <source>Field there:</source>
        <translation>Pole tam:</translation>
    </message>
    <message>
        <source>What the swings tell (✓) and what they cannot (–):</source>
        <translation>Co mówią pomiary (✓), a czego nie mogą (–):</translation>
    </message>
    <message>
        <source>(typed below)</source>
        <translation>(wpisano niżej)</translation>
    </message>
    <message>
        <source>What it will read elsewhere: %1</source>
        <translation>Co wskaże gdzie indziej: %1</translation>
    </message>
    <message>
        <source>Choose a swing first.</source>
        <translation>Najpierw wybierz pomiar.</translation>
    </message>
    <message>
        <source>Choose the base, or type its latitude and longitude.</source>
        <translation>Wybierz bazę albo wpisz jej szerokość i długość geograficzną.</translation>
    </message>
    <message>
        <source>H %1 nT, dip %2° (down +)</source>
        <translation>H %1 nT, inklinacja %2° (w dół +)</translation>
    </message>
    <message>
        <source>Swing again after the move: %1.</source>
        <translation>Po przebazowaniu wykonać pomiar: %1.</translation>
    </message>
    <message>
        <source>No new swing is needed for the move: %1.</source>
        <translation>Przebazowanie nie wymaga nowego pomiaru: %1.</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>Z %1.</translation>
    </message>
    <message>
        <source>Mind: %1.</source>
        <translation>Uwaga: %1.</translation>
    </message>
    <message>
        <source>, up to %1° possible (95 %)</source>
        <translation>, możliwe do %1° (95 %)</translation>
    </message>
    <message>
        <source>this swing alone</source>
        <translation>tylko ten pomiar</translation>
    </message>
    <message>
        <source>The band holds the whole curve with a probability of %1 %, assuming %2.</source>
        <translation>Pas obejmuje całą krzywą z prawdopodobieństwem %1 %, przy założeniu: %2.</translation>
    </message>
    <message>
        <source>Choose the base that the aircraft moves to, or type its place: the deviation that is expected there, how sure it is, and whether a new swing is needed. From several swings at different places hard and soft iron are told apart, and the prediction is surer.</source>
        <translation>Wybierz bazę, do której przenosi się statek powietrzny, albo wpisz jej położenie: oczekiwana tam dewiacja, jej pewność i potrzeba nowego pomiaru. Z kilku pomiarów w różnych miejscach rozdziela się żelazo twarde i miękkie, a prognoza jest pewniejsza.</translation>
    </message>
    <message>
        <source>What it will read elsewhere</source>
        <translation>Co wskaże gdzie indziej</translation>
    </message>
    <message>
        <source>Where the swing cannot tell, assumed to be about:</source>
        <translation>Gdzie pomiar tego nie określa, przyjęto około:</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PredictionPlot</name>
    <message>
        <source>Prediction</source>
        <translation>Prognoza</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::PreferencesPage</name>
    <message>
        <source>one that is not in this database</source>
        <translation>taki, którego nie ma w tej bazie</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>jak w systemie</translation>
    </message>
    <message>
        <source>decimal degrees (3.25°)</source>
        <translation>stopnie dziesiętne (3.25°)</translation>
    </message>
    <message>
        <source>degrees and minutes (3°15&apos;)</source>
        <translation>stopnie i minuty (3°15&apos;)</translation>
    </message>
    <message>
        <source>light</source>
        <translation>jasny</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>ciemny</translation>
    </message>
    <message>
        <source>Open the &amp;window anew</source>
        <translation>O&amp;twórz okno na nowo</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferencje</translation>
    </message>
    <message>
        <source>How it looks</source>
        <translation>Jak wygląda</translation>
    </message>
    <message>
        <source>What a new swing begins with</source>
        <translation>Od czego zaczyna się nowy pomiar</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Kopie zapasowe</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Język:</translation>
    </message>
    <message>
        <source>&amp;Angles:</source>
        <translation>&amp;Kąty:</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Motyw:</translation>
    </message>
    <message>
        <source>Te&amp;xt size:</source>
        <translation>&amp;Rozmiar tekstu:</translation>
    </message>
    <message>
        <source>Text size on the &amp;ramp:</source>
        <translation>Rozmiar tekstu na &amp;płycie:</translation>
    </message>
    <message>
        <source>Of the pages of a guided swing, on top of the text size</source>
        <translation>Stron pomiaru prowadzonego, ponad rozmiar tekstu</translation>
    </message>
    <message>
        <source>&amp;Compass base:</source>
        <translation>Krąg &amp;dewiacyjny:</translation>
    </message>
    <message>
        <source>&amp;Datum instrument:</source>
        <translation>Przyrząd &amp;wzorcowy:</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>Wy&amp;bierz…</translation>
    </message>
    <message>
        <source>asked for each time</source>
        <translation>za każdym razem pyta</translation>
    </message>
    <message>
        <source>Fo&amp;lder:</source>
        <translation>&amp;Folder:</translation>
    </message>
    <message>
        <source>Backups &amp;kept:</source>
        <translation>&amp;Ile kopii:</translation>
    </message>
    <message>
        <source>When there are more of this database in the folder, the oldest go</source>
        <translation>Gdy w folderze jest ich dla tej bazy więcej, najstarsze znikają</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>The language is another when the window is opened anew.</source>
        <translation>Język zmieni się po otwarciu okna na nowo.</translation>
    </message>
    <message>
        <source>Folder for backups</source>
        <translation>Folder na kopie zapasowe</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>Prefere&amp;ncje…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>What is chosen once for all: language, how angles are written, light or dark, text sizes, what a new swing begins with, and where backups go. A choice holds at once.</source>
        <translation>To, co wybiera się raz: język, zapis kątów, jasny lub ciemny, rozmiary tekstu, od czego zaczyna się nowy pomiar i dokąd trafiają kopie zapasowe. Wybór działa od razu.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ProgressStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ReadingBlock</name>
    <message>
        <source>%1 is no column of this table; expected one of Nominal, Magnetic, Compass, Deviation and Note</source>
        <translation>%1 nie jest kolumną tej tabeli; oczekiwano jednej z: Nominalny, Magnetyczny, Kompasowy, Dewiacja i Uwaga</translation>
    </message>
    <message>
        <source>the column %1 is pasted twice; expected it once</source>
        <translation>kolumna %1 jest wklejana dwa razy; oczekiwano jej raz</translation>
    </message>
    <message>
        <source>the block has %1 columns, and from %2 on the table has %3; expected a narrower one, or a first row of headings</source>
        <translation>blok ma kolumn: %1, a od kolumny %2 tabela ma ich %3; oczekiwano węższego albo pierwszego wiersza nagłówków</translation>
    </message>
    <message>
        <source>this column is computed, and %1 is no residual; expected a first row of headings that says which column is which</source>
        <translation>ta kolumna jest obliczana, a %1 nie jest resztą; oczekiwano pierwszego wiersza nagłówków, który nazywa kolumny</translation>
    </message>
    <message>
        <source>there is no magnetic heading beside it</source>
        <translation>obok nie ma kursu magnetycznego</translation>
    </message>
    <message>
        <source>%1 contradicts magnetic − compass, which is %2</source>
        <translation>%1 jest sprzeczne z różnicą kurs magnetyczny − kompasowy, która wynosi %2</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominalny</translation>
    </message>
    <message>
        <source>Magnetic</source>
        <translation>Magnetyczny</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Kompasowy</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Dewiacja</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Reszta</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>there is no text to paste; expected cells of a spreadsheet</source>
        <translation>nie ma tekstu do wklejenia; oczekiwano komórek arkusza</translation>
    </message>
    <message>
        <source>row %1, %2</source>
        <translation>wiersz %1, %2</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Readings</name>
    <message>
        <source>a true heading needs the variation: state it in the particulars of the swing first</source>
        <translation>kurs rzeczywisty wymaga deklinacji: najpierw podaj ją w danych pomiaru</translation>
    </message>
    <message>
        <source>this row has no nominal heading to accept; type the magnetic heading</source>
        <translation>ten wiersz nie ma kursu nominalnego do przyjęcia; wpisz kurs magnetyczny</translation>
    </message>
    <message>
        <source>type the magnetic heading first: compass = magnetic − deviation</source>
        <translation>najpierw wpisz kurs magnetyczny: kurs kompasowy = magnetyczny − dewiacja</translation>
    </message>
    <message>
        <source>this column is computed; type into magnetic, compass or deviation</source>
        <translation>ta kolumna jest obliczana; wpisuj w kolumny: magnetyczny, kompasowy lub dewiacja</translation>
    </message>
    <message>
        <source>nominal heading</source>
        <translation>kurs nominalny</translation>
    </message>
    <message>
        <source>magnetic heading</source>
        <translation>kurs magnetyczny</translation>
    </message>
    <message>
        <source>compass reading</source>
        <translation>odczyt busoli</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>dewiacja</translation>
    </message>
    <message>
        <source>note</source>
        <translation>uwaga</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ReadingsModel</name>
    <message>
        <source>The heading that the aircraft was turned to, magnetic</source>
        <translation>Kurs magnetyczny, na który obrócono statek powietrzny</translation>
    </message>
    <message>
        <source>The magnetic heading that the datum gave</source>
        <translation>Kurs magnetyczny wskazany przez wzorzec</translation>
    </message>
    <message>
        <source>What the compass read</source>
        <translation>Wskazanie busoli</translation>
    </message>
    <message>
        <source>Magnetic − compass, east positive. Type it, and the compass heading follows</source>
        <translation>Kurs magnetyczny − kompasowy, wschodnia dodatnia. Po wpisaniu kurs kompasowy wynika z niej</translation>
    </message>
    <message>
        <source>Deviation read − deviation of the approximate fit</source>
        <translation>Dewiacja odczytana − dewiacja z przybliżonego dopasowania</translation>
    </message>
    <message>
        <source>Whether the reading counts</source>
        <translation>Czy odczyt się liczy</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>t = %1</source>
        <translation>t = %1</translation>
    </message>
    <message>
        <source>excluded: %1</source>
        <translation>pominięty: %1</translation>
    </message>
    <message>
        <source>suspect, %1</source>
        <translation>wątpliwy, %1</translation>
    </message>
    <message>
        <source>The nominal heading: nobody has read it yet. Enter or = accepts it, typing replaces it</source>
        <translation>Kurs nominalny: nikt go jeszcze nie odczytał. Enter lub = przyjmuje go, wpisanie zastępuje</translation>
    </message>
    <message>
        <source>%1 in a new row</source>
        <translation>%1 w nowym wierszu</translation>
    </message>
    <message>
        <source>Residual and State are computed: they were passed over.</source>
        <translation>Reszta i Stan są obliczane: pominięto je.</translation>
    </message>
    <message>
        <source>000 and 360 are one heading: the second is left out.</source>
        <translation>000 i 360 to ten sam kurs: drugi pominięto.</translation>
    </message>
    <message>
        <source>000 and 360 are one heading, with different readings: look which is right.</source>
        <translation>000 i 360 to ten sam kurs z różnymi odczytami: sprawdź, który jest właściwy.</translation>
    </message>
    <message>
        <source>emptying of cells</source>
        <translation>opróżnienie komórek</translation>
    </message>
    <message>
        <source>pasting of a row</source>
        <translation>wklejenie wiersza</translation>
    </message>
    <message>
        <source>pasting of %1 rows</source>
        <translation>wklejenie wierszy: %1</translation>
    </message>
    <message>
        <source>One row pasted.</source>
        <translation>Wklejono jeden wiersz.</translation>
    </message>
    <message>
        <source>%1 rows pasted.</source>
        <translation>Wklejono wierszy: %1.</translation>
    </message>
    <message>
        <source>incomplete: not read yet</source>
        <translation>niepełny: jeszcze nie odczytano</translation>
    </message>
    <message>
        <source>incomplete: both headings are missing</source>
        <translation>niepełny: brak obu kursów</translation>
    </message>
    <message>
        <source>incomplete: the compass heading is missing</source>
        <translation>niepełny: brak kursu kompasowego</translation>
    </message>
    <message>
        <source>incomplete: the magnetic heading is missing</source>
        <translation>niepełny: brak kursu magnetycznego</translation>
    </message>
    <message>
        <source>Not stored: %1
Stored: %2
Escape puts the stored value back.</source>
        <translation>Niezapisane: %1
Zapisane: %2
Escape przywraca zapisaną wartość.</translation>
    </message>
    <message>
        <source>%1, not stored; stored: %2</source>
        <translation>%1, niezapisane; zapisane: %2</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ReadingsTable</name>
    <message>
        <source>Cu&amp;t</source>
        <translation>Wy&amp;tnij</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiuj</translation>
    </message>
    <message>
        <source>Copy with &amp;headings</source>
        <translation>Kopiuj z &amp;nagłówkami</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Wklej</translation>
    </message>
    <message>
        <source>Nothing was pasted: %1</source>
        <translation>Niczego nie wklejono: %1</translation>
    </message>
    <message>
        <source>&amp;Empty the cells</source>
        <translation>&amp;Opróżnij komórki</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Zaznacz w&amp;szystko</translation>
    </message>
    <message>
        <source>“%1” was being typed when another window or program changed the swing: it is not stored.</source>
        <translation>Wpisywano „%1”, gdy inne okno albo program zmienił pomiar: nie jest zapisane.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::RecordDocuments</name>
    <message>
        <source>RADIO ON</source>
        <translation>RADIO WŁ.</translation>
    </message>
    <message>
        <source>RADIO OFF</source>
        <translation>RADIO WYŁ.</translation>
    </message>
    <message>
        <source>STEER</source>
        <translation>STERUJ</translation>
    </message>
    <message>
        <source>%1 (%2° on %3)</source>
        <translation>%1 (%2° na kursie %3)</translation>
    </message>
    <message>
        <source>the swing with the radio in the other state (record %1): %2</source>
        <translation>pomiar przy radiu w drugim stanie (zapis %1): %2</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Recovery</name>
    <message>
        <source>earlier</source>
        <translation>wcześniej</translation>
    </message>
    <message>
        <source>%1: kept %2, stored since %3</source>
        <translation>%1: zachowane %2, zapisane od tego czasu %3</translation>
    </message>
    <message>
        <source>%1, kept %2. %3</source>
        <translation>%1, zachowane %2. %3</translation>
    </message>
    <message>
        <source>%1, kept %2: step %3 of the guided swing; another has been stored in its place since</source>
        <translation>%1, zachowane %2: krok %3 pomiaru prowadzonego; od tego czasu w jego miejscu zapisano inny</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ReferencePage</name>
    <message>
        <source>Heading error</source>
        <translation>Błąd kursu</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Wzmocnienie</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>&amp;Film</translation>
    </message>
    <message>
        <source>no vertical gyro</source>
        <translation>bez żyroskopu pionu</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>pierwszy rząd</translation>
    </message>
    <message>
        <source>second order, damped</source>
        <translation>drugi rząd, tłumiony</translation>
    </message>
    <message>
        <source>second order, integral</source>
        <translation>drugi rząd, całkujący</translation>
    </message>
    <message>
        <source>third order</source>
        <translation>trzeci rząd</translation>
    </message>
    <message>
        <source>&amp;Levelling:</source>
        <translation>&amp;Poziomowanie:</translation>
    </message>
    <message>
        <source>τ&amp;1:</source>
        <translation>τ&amp;1:</translation>
    </message>
    <message>
        <source>τ&amp;2:</source>
        <translation>τ&amp;2:</translation>
    </message>
    <message>
        <source>τ&amp;3:</source>
        <translation>τ&amp;3:</translation>
    </message>
    <message>
        <source>&amp;Slaving τ:</source>
        <translation>&amp;Korekcja τ:</translation>
    </message>
    <message>
        <source>L&amp;atitude:</source>
        <translation>&amp;Szerokość:</translation>
    </message>
    <message>
        <source>&amp;Dip:</source>
        <translation>&amp;Inklinacja:</translation>
    </message>
    <message>
        <source>S&amp;peed:</source>
        <translation>Prę&amp;dkość:</translation>
    </message>
    <message>
        <source>&amp;Bank:</source>
        <translation>Przec&amp;hylenie:</translation>
    </message>
    <message>
        <source>G&amp;usts:</source>
        <translation>Pod&amp;muchy:</translation>
    </message>
    <message>
        <source>Du&amp;ration:</source>
        <translation>&amp;Czas trwania:</translation>
    </message>
    <message>
        <source>needle</source>
        <translation>igła</translation>
    </message>
    <message>
        <source>flux valve</source>
        <translation>czujnik indukcyjny</translation>
    </message>
    <message>
        <source>flux valve, slaved gyro</source>
        <translation>czujnik indukcyjny, żyroskop z korekcją</translation>
    </message>
    <message>
        <source>&amp;Compass:</source>
        <translation>&amp;Busola:</translation>
    </message>
    <message>
        <source>from s</source>
        <translation>od s</translation>
    </message>
    <message>
        <source>to s</source>
        <translation>do s</translation>
    </message>
    <message>
        <source>turn °/s</source>
        <translation>zakręt °/s</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
    </message>
    <message>
        <source>climb m/s</source>
        <translation>wznosz. m/s</translation>
    </message>
    <message>
        <source>A manoeuvre a row; one more may be typed in the last row. An empty row is taken out.</source>
        <translation>Manewr w wierszu; następny można wpisać w ostatnim wierszu. Pusty wiersz znika.</translation>
    </message>
    <message>
        <source>Heading references in flight</source>
        <translation>Wzorce kursu w locie</translation>
    </message>
    <message>
        <source>&amp;Open scenario…</source>
        <translation>&amp;Otwórz scenariusz…</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>„%1” nie jest liczbą</translation>
    </message>
    <message>
        <source>Slaving leaves %1° of the drift.</source>
        <translation>Korekcja zostawia %1° dryfu.</translation>
    </message>
    <message>
        <source>A flight and its heading references</source>
        <translation>Lot i jego wzorce kursu</translation>
    </message>
    <message>
        <source>Scenarios (*.json *.csv);;All files (*)</source>
        <translation>Scenariusze (*.json *.csv);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>Zapisywanie scenariusza</translation>
    </message>
    <message>
        <source>Scenarios (*.json);;Run as a table (*.csv)</source>
        <translation>Scenariusze (*.json);;Przebieg jako tabela (*.csv)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Sprawozdanie</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Latitude %1°, dip %2°, %3 m/s, %4 s; error is read − magnetic; a share is the run with all less the run without it.</source>
        <translation>Szerokość %1°, inklinacja %2°, %3 m/s, %4 s; błąd to odczytany − magnetyczny; udział to przebieg ze wszystkim minus przebieg bez danego źródła.</translation>
    </message>
    <message>
        <source>Manoeuvres</source>
        <translation>Manewry</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>zakręt</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>przyspieszenie</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>wznoszenie</translation>
    </message>
    <message>
        <source>Heading &amp;references in flight</source>
        <translation>Wzorce ku&amp;rsu w locie</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Draw manoeuvres on the time line or type them, turn the sliders, and see what a vertical gyro, a needle or a slaved gyro makes of them: the error read − magnetic with the share of each source (the run with all less the run without it), and the gains of the loops against frequency. Levelling: τ2 dm/dt + m = ε, dσ/dt = −(m + ∫m dt/τ3)/τ1 + ω_D − θ̇; third order needs τ3 &gt; τ2. Slaving: τ_s de/dt + e = e_m + τ_s d. Vertical: σ = τ1(ω_D − θ̇) is left for good where no integral takes it away; its gain at ω is 1/√(1 + (τ1ω)²) of first order, and that of slaving 1/√(1 + (τ_sω)²). A tilted sensor is wrong by −(φ cos ψ − θ sin ψ) tan I. Source: Kayton and Fried, Avionics Navigation Systems, chapter 9; where it is misprinted, recomputed.</source>
        <translation>Narysuj manewry na osi czasu lub wpisz je, przesuwaj suwaki i zobacz, co robi z nich żyroskop pionu, igła lub żyroskop z korekcją: błąd odczytany − magnetyczny z udziałem każdego źródła (przebieg ze wszystkim minus przebieg bez niego) oraz wzmocnienia pętli względem częstotliwości. Poziomowanie: τ2 dm/dt + m = ε, dσ/dt = −(m + ∫m dt/τ3)/τ1 + ω_D − θ̇; trzeci rząd wymaga τ3 &gt; τ2. Korekcja: τ_s de/dt + e = e_m + τ_s d. Pion: σ = τ1(ω_D − θ̇) zostaje na stałe tam, gdzie nie usuwa go całkowanie; wzmocnienie przy ω wynosi dla pierwszego rzędu 1/√(1 + (τ1ω)²), a dla korekcji 1/√(1 + (τ_sω)²). Pochylony czujnik myli się o −(φ cos ψ − θ sin ψ) tan I. Źródło: Kayton i Fried, Avionics Navigation Systems, rozdział 9; gdzie są błędy druku, przeliczono.</translation>
    </message>
    <message>
        <source>Save the &amp;scenario or its run…</source>
        <translation>&amp;Zapisz scenariusz lub jego przebieg…</translation>
    </message>
    <message>
        <source>Write the &amp;report…</source>
        <translation>Zapisz &amp;sprawozdanie…</translation>
    </message>
    <message>
        <source>Arrow keys, or Shift while dragging: fine steps; page keys: coarse ones; double click: back to where it began</source>
        <translation>Strzałki albo Shift przy przeciąganiu: drobne kroki; Page Up i Down: grube; dwuklik: powrót do początku</translation>
    </message>
    <message>
        <source>As its newest swing has it, level: what a swing on the ground cannot tell (R, c, f, g, h, k) counts as none.</source>
        <translation>Jak w najnowszej dewiacji, w poziomie: to, czego dewiacja na ziemi nie mówi (R, c, f, g, h, k), przyjmuje się jako zero.</translation>
    </message>
    <message>
        <source>&amp;Own deviation of %1</source>
        <translation>&amp;Własna dewiacja %1</translation>
    </message>
    <message>
        <source>Levelling: natural period %1 s, damping %2, largest gain %3; standoff to rates and drift %4° (Coriolis, in the curve, is not in it).</source>
        <translation>Poziomowanie: okres własny %1 s, tłumienie %2, największe wzmocnienie %3; odchyłka od prędkości kątowych i dryfu %4° (bez przyspieszenia Coriolisa, które jest w krzywej).</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::ReferenceWords</name>
    <message>
        <source>tilt</source>
        <translation>pochylenie pionu</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>dewiacja</translation>
    </message>
    <message>
        <source>slaving</source>
        <translation>korekcja</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>dryf</translation>
    </message>
    <message>
        <source>gimbal</source>
        <translation>zawieszenie</translation>
    </message>
    <message>
        <source>card</source>
        <translation>tablica</translation>
    </message>
    <message>
        <source>together</source>
        <translation>razem</translation>
    </message>
    <message>
        <source>slaving and together</source>
        <translation>korekcja i razem</translation>
    </message>
    <message>
        <source>error shown</source>
        <translation>błąd wskazania</translation>
    </message>
    <message>
        <source>tilt of the vertical</source>
        <translation>pochylenie pionu</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>czas (s)</translation>
    </message>
    <message>
        <source>read − magnetic (°), shares of the sources stacked</source>
        <translation>odczytany − magnetyczny (°), udziały źródeł jeden na drugim</translation>
    </message>
    <message>
        <source>%1 s: error %2°, tilt %3°; %4</source>
        <translation>%1 s: błąd %2°, pochylenie %3°; %4</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>częstotliwość (Hz)</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>wzmocnienie</translation>
    </message>
    <message>
        <source>levelling %1</source>
        <translation>poziomowanie %1</translation>
    </message>
    <message>
        <source>slaving %1</source>
        <translation>korekcja %1</translation>
    </message>
    <message>
        <source>period %1 s: gain of %2</source>
        <translation>okres %1 s: wzmocnienie %2</translation>
    </message>
    <message>
        <source>no loop: neither a vertical gyro nor a time constant of slaving</source>
        <translation>brak pętli: ani żyroskopu pionu, ani stałej czasowej korekcji</translation>
    </message>
    <message>
        <source>levelling: tilt of gyro ÷ tilt of the apparent vertical</source>
        <translation>poziomowanie: pochylenie żyroskopu ÷ pochylenie pozornego pionu</translation>
    </message>
    <message>
        <source>slaving: gyro ÷ sensor</source>
        <translation>korekcja: żyroskop ÷ czujnik</translation>
    </message>
    <message>
        <source>magnetic</source>
        <translation>magnetyczny</translation>
    </message>
    <message>
        <source>read</source>
        <translation>wskazanie</translation>
    </message>
    <message>
        <source>vertical: %1° forward, %2° to starboard</source>
        <translation>pion: %1° do przodu, %2° w prawo</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorActions</name>
    <message>
        <source>Sensor model (*.json)</source>
        <translation>Model czujnika (*.json)</translation>
    </message>
    <message>
        <source>Es&amp;timate from swings</source>
        <translation>&amp;Oszacuj z pomiarów</translation>
    </message>
    <message>
        <source>&amp;Iron bench…</source>
        <translation>&amp;Stanowisko żelaza…</translation>
    </message>
    <message>
        <source>Loa&amp;d model…</source>
        <translation>&amp;Wczytaj model…</translation>
    </message>
    <message>
        <source>Save &amp;model…</source>
        <translation>Zapisz &amp;model…</translation>
    </message>
    <message>
        <source>Newest swing, B and C as &amp;hard iron</source>
        <translation>Najnowszy pomiar, B i C jako żelazo &amp;twarde</translation>
    </message>
    <message>
        <source>Newest swing, B and C as &amp;vertical soft iron</source>
        <translation>Najnowszy pomiar, B i C jako pionowe żelazo &amp;miękkie</translation>
    </message>
    <message>
        <source>Swings at several &amp;places, separated</source>
        <translation>Pomiary w kilku &amp;miejscach, rozdzielone</translation>
    </message>
    <message>
        <source>estimate from swings</source>
        <translation>oszacowanie z pomiarów</translation>
    </message>
    <message>
        <source>Load a sensor model</source>
        <translation>Wczytywanie modelu czujnika</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>wczytanie %1</translation>
    </message>
    <message>
        <source>The model was loaded; its field was not: %1</source>
        <translation>Model wczytano; jego pola nie: %1</translation>
    </message>
    <message>
        <source>Save the sensor model</source>
        <translation>Zapisywanie modelu czujnika</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorChooser</name>
    <message>
        <source>Sensor models of this compass</source>
        <translation>Modele czujnika tej busoli</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>A new model, all zero</source>
        <translation>Nowy model, same zera</translation>
    </message>
    <message>
        <source>new sensor model</source>
        <translation>nowy model czujnika</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Powiel</translation>
    </message>
    <message>
        <source>A copy of this model, to be compared with it</source>
        <translation>Kopia tego modelu do porównania</translation>
    </message>
    <message>
        <source>duplicate of %1</source>
        <translation>kopia %1</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Remove this model (can be undone)</source>
        <translation>Usuń ten model (można cofnąć)</translation>
    </message>
    <message>
        <source>a model must have a name</source>
        <translation>model musi mieć nazwę</translation>
    </message>
    <message>
        <source>another model of this compass has this name</source>
        <translation>inny model tej busoli ma tę nazwę</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nazwa:</translation>
    </message>
    <message>
        <source>N&amp;ote:</source>
        <translation>&amp;Uwaga:</translation>
    </message>
    <message>
        <source>The database can only be read: sliders play, nothing is stored.</source>
        <translation>Bazę można tylko czytać: suwaki działają, nic nie jest zapisywane.</translation>
    </message>
    <message>
        <source>This compass has no model yet. The first figure that you set makes one.</source>
        <translation>Ta busola nie ma jeszcze modelu. Utworzy go pierwsza ustawiona liczba.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorEditor</name>
    <message>
        <source>new model</source>
        <translation>nowy model</translation>
    </message>
    <message>
        <source>new sensor model</source>
        <translation>nowy model czujnika</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>usunięcie %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorEstimate</name>
    <message>
        <source>no swing of this compass tells all five exact coefficients; expected one with five or more headings all round</source>
        <translation>żaden pomiar tej busoli nie określa wszystkich pięciu współczynników dokładnych; oczekiwano pomiaru na co najmniej pięciu kursach dookoła</translation>
    </message>
    <message numerus="yes">
        <source>swings at %n place(s) with a known field; expected two or more where H and dip differ (sites need latitude and longitude)</source>
        <translation>
            <numerusform>pomiary w %n miejscu o znanym polu; oczekiwano co najmniej dwóch o różnych H i inklinacji (miejsca wymagają szerokości i długości)</numerusform>
            <numerusform>pomiary w %n miejscach o znanym polu; oczekiwano co najmniej dwóch o różnych H i inklinacji (miejsca wymagają szerokości i długości)</numerusform>
            <numerusform>pomiary w %n miejscach o znanym polu; oczekiwano co najmniej dwóch o różnych H i inklinacji (miejsca wymagają szerokości i długości)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorFieldForm</name>
    <message>
        <source>Site of the field</source>
        <translation>Miejsce pola</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>wpisane</translation>
    </message>
    <message>
        <source>Date of the field</source>
        <translation>Data pola</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>horizontal field H</source>
        <translation>pole poziome H</translation>
    </message>
    <message>
        <source>dip</source>
        <translation>inklinacja</translation>
    </message>
    <message>
        <source>dip, positive down</source>
        <translation>inklinacja, dodatnia w dół</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>vertical field Z, positive down</source>
        <translation>pole pionowe Z, dodatnie w dół</translation>
    </message>
    <message>
        <source>No field: %1.</source>
        <translation>Brak pola: %1.</translation>
    </message>
    <message>
        <source>%1: F %2 nT</source>
        <translation>%1: F %2 nT</translation>
    </message>
    <message>
        <source> · H below %1 nT: a compass is unreliable here</source>
        <translation> · H poniżej %1 nT: busola jest tu niepewna</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorForm</name>
    <message>
        <source>&amp;Add a circuit</source>
        <translation>&amp;Dodaj obwód</translation>
    </message>
    <message>
        <source>Hard iron</source>
        <translation>Żelazo twarde</translation>
    </message>
    <message>
        <source>Soft iron</source>
        <translation>Żelazo miękkie</translation>
    </message>
    <message>
        <source>Electrical circuits</source>
        <translation>Obwody elektryczne</translation>
    </message>
    <message>
        <source>Misalignment of the sensor</source>
        <translation>Niewspółosiowość czujnika</translation>
    </message>
    <message>
        <source>Soft constants (act as hard iron does)</source>
        <translation>Stałe miękkie (działają jak żelazo twarde)</translation>
    </message>
    <message>
        <source>as si&amp;ze and direction</source>
        <translation>jako &amp;wielkość i kierunek</translation>
    </message>
    <message>
        <source>new circuit</source>
        <translation>nowy obwód</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>usunięto %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorMaps</name>
    <message>
        <source>Ma&amp;p</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>S&amp;urface</source>
        <translation>&amp;Powierzchnia</translation>
    </message>
    <message>
        <source>Level swin&amp;g</source>
        <translation>&amp;Obrót w poziomie</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorPage</name>
    <message>
        <source>Earth&apos;s field</source>
        <translation>pole Ziemi</translation>
    </message>
    <message>
        <source>Sensor model · %1 · %2</source>
        <translation>Model czujnika · %1 · %2</translation>
    </message>
    <message>
        <source> · DEMONSTRATION</source>
        <translation> · DANE POKAZOWE</translation>
    </message>
    <message>
        <source>No field: %1</source>
        <translation>Brak pola: %1</translation>
    </message>
    <message>
        <source>Export the plot</source>
        <translation>Eksportuj wykres</translation>
    </message>
    <message>
        <source>PNG picture (*.png);;SVG drawing (*.svg);;PDF document (*.pdf)</source>
        <translation>Obraz PNG (*.png);;Rysunek SVG (*.svg);;Dokument PDF (*.pdf)</translation>
    </message>
    <message>
        <source>&amp;Sensor model of this compass</source>
        <translation>&amp;Model czujnika tej busoli</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Sensor model</source>
        <translation>Model czujnika</translation>
    </message>
    <message>
        <source>What stands between the Earth&apos;s field and the compass: turn the figures and the maps of its deviation over heading, pitch and roll follow. The table below says which figure causes how much of each coefficient. Estimate takes the figures from the swings of this compass.</source>
        <translation>Co stoi między polem Ziemi a busolą: zmieniaj liczby, a mapy dewiacji względem kursu, pochylenia i przechylenia podążą za nimi. Tabela poniżej mówi, która liczba ile wnosi do każdego współczynnika. Oszacowanie bierze liczby z pomiarów tej busoli.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorParameters</name>
    <message>
        <source>forward</source>
        <translation>do przodu</translation>
    </message>
    <message>
        <source>to starboard</source>
        <translation>w prawo</translation>
    </message>
    <message>
        <source>down</source>
        <translation>w dół</translation>
    </message>
    <message>
        <source>soft iron %1: field %2 for each nT %3</source>
        <translation>żelazo miękkie %1: pole %2 na każdy nT %3</translation>
    </message>
    <message>
        <source>hard iron P, forward</source>
        <translation>żelazo twarde P, w przód</translation>
    </message>
    <message>
        <source>hard iron Q, to starboard</source>
        <translation>żelazo twarde Q, w prawo</translation>
    </message>
    <message>
        <source>hard iron R, down</source>
        <translation>żelazo twarde R, w dół</translation>
    </message>
    <message>
        <source>size</source>
        <translation>wielkość</translation>
    </message>
    <message>
        <source>size of the hard iron</source>
        <translation>wielkość żelaza twardego</translation>
    </message>
    <message>
        <source>elevation γ of the hard iron, upward from the body&apos;s xy plane</source>
        <translation>elewacja γ żelaza twardego, w górę od płaszczyzny xy płatowca</translation>
    </message>
    <message>
        <source>azimuth δ of the hard iron, from forward towards starboard (not the deviation)</source>
        <translation>azymut δ żelaza twardego, od przodu ku prawej burcie (nie dewiacja)</translation>
    </message>
    <message>
        <source>soft constant D1, forward</source>
        <translation>stała miękka D1, w przód</translation>
    </message>
    <message>
        <source>soft constant D2, to starboard</source>
        <translation>stała miękka D2, w prawo</translation>
    </message>
    <message>
        <source>soft constant D3, down</source>
        <translation>stała miękka D3, w dół</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>przechylenie</translation>
    </message>
    <message>
        <source>the sensor rolled in its mount, starboard side down +</source>
        <translation>czujnik przechylony w mocowaniu, prawa strona w dół +</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>pochylenie</translation>
    </message>
    <message>
        <source>the sensor pitched in its mount, front up +</source>
        <translation>czujnik pochylony w mocowaniu, przód w górę +</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>odchylenie</translation>
    </message>
    <message>
        <source>the sensor turned in its mount, clockwise from above +</source>
        <translation>czujnik obrócony w mocowaniu, w prawo patrząc z góry +</translation>
    </message>
    <message>
        <source>current</source>
        <translation>prąd</translation>
    </message>
    <message>
        <source>field %1 for each ampere, %2</source>
        <translation>pole %1 na każdy amper, %2</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorPictures</name>
    <message>
        <source>%1 − %2</source>
        <translation>%1 − %2</translation>
    </message>
    <message>
        <source>MODELLED · %1</source>
        <translation>Z MODELU · %1</translation>
    </message>
    <message>
        <source>MODELLED: %1, level</source>
        <translation>Z MODELU: %1, w poziomie</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorTestWords</name>
    <message>
        <source>frequency (Hz)</source>
        <translation>częstotliwość (Hz)</translation>
    </message>
    <message>
        <source>density (%1²/Hz)</source>
        <translation>gęstość (%1²/Hz)</translation>
    </message>
    <message>
        <source>%1 Hz: %2 %3²/Hz</source>
        <translation>%1 Hz: %2 %3²/Hz</translation>
    </message>
    <message>
        <source>; %1, amplitude %2 %3</source>
        <translation>; %1, amplituda %2 %3</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>czas (s)</translation>
    </message>
    <message>
        <source>frequency (Hz); dark: strong, decades below the strongest</source>
        <translation>częstotliwość (Hz); ciemne: silne, dekady poniżej najsilniejszego</translation>
    </message>
    <message>
        <source>field less that of before (nT)</source>
        <translation>pole minus pole przedtem (nT)</translation>
    </message>
    <message>
        <source>density of %1</source>
        <translation>gęstość %1</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>linie</translation>
    </message>
    <message>
        <source>behind the filter</source>
        <translation>za filtrem</translation>
    </message>
    <message>
        <source>the log is too short for a spectrogram: it needs two segments at least</source>
        <translation>zapis jest za krótki na spektrogram: potrzeba co najmniej dwóch segmentów</translation>
    </message>
    <message>
        <source>%1 s, %2 Hz: %3 %4²/Hz</source>
        <translation>%1 s, %2 Hz: %3 %4²/Hz</translation>
    </message>
    <message>
        <source>%1 s: x %2, y %3, z %4 nT</source>
        <translation>%1 s: x %2, y %3, z %4 nT</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SensorTestsPage</name>
    <message>
        <source>&amp;Tests of a sensor: spectrum, coil, interference…</source>
        <translation>&amp;Próby czujnika: widmo, cewka, zakłócenia…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+T</source>
        <translation>Ctrl+Alt+T</translation>
    </message>
    <message>
        <source>Write the &amp;report as PDF…</source>
        <translation>Zapisz &amp;sprawozdanie jako PDF…</translation>
    </message>
    <message>
        <source>&amp;Open a log…</source>
        <translation>&amp;Otwórz zapis…</translation>
    </message>
    <message>
        <source>Open the &amp;actions…</source>
        <translation>Otwórz &amp;czynności…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>column: strongest axis</source>
        <translation>kolumna: najsilniejsza oś</translation>
    </message>
    <message>
        <source>tachometer column</source>
        <translation>kolumna obrotomierza</translation>
    </message>
    <message>
        <source>filter delay, ms</source>
        <translation>opóźnienie filtru, ms</translation>
    </message>
    <message>
        <source>limits: 500, 500, 800 nT</source>
        <translation>granice: 500, 500, 800 nT</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Widmo</translation>
    </message>
    <message>
        <source>Spectrogram</source>
        <translation>Spektrogram</translation>
    </message>
    <message>
        <source>Interference</source>
        <translation>Zakłócenia</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Coil bench</source>
        <translation>Stanowisko z cewkami</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Czynności</translation>
    </message>
    <message>
        <source>Reading… %1 %</source>
        <translation>Wczytywanie… %1 %</translation>
    </message>
    <message>
        <source>Tests of a sensor from its log</source>
        <translation>Próby czujnika z jego zapisu</translation>
    </message>
    <message>
        <source>Open a log of the sensor: time_s, bx_nT, by_nT, bz_nT.</source>
        <translation>Otwórz zapis czujnika: time_s, bx_nT, by_nT, bz_nT.</translation>
    </message>
    <message>
        <source>Open a log of the sensor while it stands still, then the list of actions: time_s, action.</source>
        <translation>Otwórz zapis stojącego czujnika, potem wykaz czynności: time_s, action.</translation>
    </message>
    <message>
        <source>Open a sensor log</source>
        <translation>Otwieranie zapisu czujnika</translation>
    </message>
    <message>
        <source>Sensor logs (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>Zapisy czujnika (*.csv *.txt *.tsv *.dat);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Open the actions</source>
        <translation>Otwieranie czynności</translation>
    </message>
    <message>
        <source>Actions (*.csv);;All files (*)</source>
        <translation>Czynności (*.csv);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>“%1” is no delay; expected 0.01 to 10000 ms</source>
        <translation>„%1” nie jest opóźnieniem; oczekiwano od 0.01 do 10000 ms</translation>
    </message>
    <message>
        <source>“%1” are no limits; expected three numbers above 0 in nT: x, y, z</source>
        <translation>„%1” to nie granice; oczekiwano trzech liczb większych od 0 w nT: x, y, z</translation>
    </message>
    <message>
        <source>Open the list of actions: time_s, action.</source>
        <translation>Otwórz wykaz czynności: time_s, action.</translation>
    </message>
    <message>
        <source>Passes: no action changes the field by more than the limits.</source>
        <translation>Spełnia: żadna czynność nie zmienia pola bardziej, niż pozwalają granice.</translation>
    </message>
    <message>
        <source>Does not pass: an action changes the field by more than the limits.</source>
        <translation>Nie spełnia: któraś czynność zmienia pole bardziej, niż pozwalają granice.</translation>
    </message>
    <message>
        <source>Nothing to write yet: this test has no result</source>
        <translation>Nie ma jeszcze czego zapisać: ta próba nie ma wyniku</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisywanie sprawozdania</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>zapisano %1</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>Zabudowa</translation>
    </message>
    <message>
        <source>Spectrum: Welch&apos;s method (1967), periodic Hann window, half overlap; lines are named by the supplies (50, 60, 115, 400 Hz and harmonics) or by orders of a rotor, also where sampling folds them down: a frequency f stands at |f − n·rate|, and one that falls on 0 looks like hard iron. Notches of Q 5 cost 1/(2π f Q) of delay, a low-pass 1/(2π f). Coil: measured = scale · applied + bias + temperature + hysteresis; opened from a compass, a bench is kept with it, held against earlier ones, and its noise, hysteresis and nonlinearity are in the errors of every later swing. Interference: the aircraft stands still, things are switched at noted times, and the field must not change by more than 5, 5 and 8 mG (500, 500, 800 nT) on x, y and z, as makers ask.</source>
        <translation>Widmo: metoda Welcha (1967), okresowe okno Hanna, zakładka połowy; linie nazywa się według zasilania (50, 60, 115, 400 Hz i harmoniczne) albo rzędów wirnika, także tam, gdzie odbija je próbkowanie: częstotliwość f stoi na |f − n·częstość|, a ta, która pada na 0, wygląda jak żelazo twarde. Wycięcie o Q 5 kosztuje 1/(2π f Q) opóźnienia, filtr dolnoprzepustowy 1/(2π f). Cewka: zmierzone = skala · przyłożone + przesunięcie + temperatura + histereza; otwarty od strony busoli pomiar zachowuje się przy niej, zestawia z wcześniejszymi, a jego szum, histereza i nieliniowość wchodzą w błędy każdego późniejszego pomiaru dewiacji. Zakłócenia: statek powietrzny stoi, o zanotowanych czasach przełącza się odbiorniki, a pole nie może zmienić się bardziej niż o 5, 5 i 8 mG (500, 500, 800 nT) na x, y i z, jak żądają producenci.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SightWords</name>
    <message>
        <source>looking, azimuth in the aircraft (°)</source>
        <translation>kierunek patrzenia, azymut w statku powietrznym (°)</translation>
    </message>
    <message>
        <source>error of the line, turret&apos;s axes (°)</source>
        <translation>błąd linii, osie wieżyczki (°)</translation>
    </message>
    <message>
        <source>looking %1°: </source>
        <translation>patrząc na %1°: </translation>
    </message>
    <message>
        <source>at %1° azimuth %2°, elevation %3°</source>
        <translation>na %1° azymut %2°, elewacja %3°</translation>
    </message>
    <message>
        <source>Enter the Earth&apos;s field and its dip.</source>
        <translation>Podaj pole Ziemi i jego inklinację.</translation>
    </message>
    <message>
        <source>azimuth, looking %1° up</source>
        <translation>azymut, patrząc %1° w górę</translation>
    </message>
    <message>
        <source>elevation, looking %1° up</source>
        <translation>elewacja, patrząc %1° w górę</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SigningPanel</name>
    <message>
        <source>role</source>
        <translation>rola</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nazwisko</translation>
    </message>
    <message>
        <source>licence</source>
        <translation>licencja</translation>
    </message>
    <message>
        <source>time (UTC)</source>
        <translation>czas (UTC)</translation>
    </message>
    <message>
        <source>stands for</source>
        <translation>poświadcza</translation>
    </message>
    <message>
        <source>&amp;Sign</source>
        <translation>&amp;Podpisz</translation>
    </message>
    <message>
        <source>Amend in a new &amp;revision</source>
        <translation>Zmień w nowym &amp;wydaniu</translation>
    </message>
    <message>
        <source>what</source>
        <translation>co</translation>
    </message>
    <message>
        <source>before</source>
        <translation>przedtem</translation>
    </message>
    <message>
        <source>now</source>
        <translation>teraz</translation>
    </message>
    <message>
        <source>what was done</source>
        <translation>co zrobiono</translation>
    </message>
    <message>
        <source>licence, stamp or service number</source>
        <translation>numer licencji, stempla lub legitymacji</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>powód</translation>
    </message>
    <message>
        <source>All that was &amp;done to it</source>
        <translation>&amp;Wszystko, co z nim zrobiono</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2 · %3: %n readings that count. </source>
        <translation>
            <numerusform>%1 · %2 · %3: %n liczący się odczyt. </numerusform>
            <numerusform>%1 · %2 · %3: %n liczące się odczyty. </numerusform>
            <numerusform>%1 · %2 · %3: %n liczących się odczytów. </numerusform>
        </translation>
    </message>
    <message>
        <source> · revision %1, because: %2</source>
        <translation> · wydanie %1, ponieważ: %2</translation>
    </message>
    <message>
        <source>&amp;Complete</source>
        <translation>&amp;Zakończ</translation>
    </message>
    <message>
        <source>Open a&amp;gain</source>
        <translation>&amp;Otwórz ponownie</translation>
    </message>
    <message>
        <source>✓ what the swing says now (%1…)</source>
        <translation>✓ obecną treść pomiaru (%1…)</translation>
    </message>
    <message>
        <source>✗ no longer: the swing was changed after it</source>
        <translation>✗ już nie: pomiar później zmieniono</translation>
    </message>
    <message>
        <source>✗</source>
        <translation>✗</translation>
    </message>
    <message>
        <source>✗ no longer</source>
        <translation>✗ już nieważny</translation>
    </message>
    <message>
        <source>signed as %1: %2</source>
        <translation>podpisano jako %1: %2</translation>
    </message>
    <message>
        <source>name not verified</source>
        <translation>nazwiska nie sprawdzono</translation>
    </message>
    <message>
        <source>the key is being checked …</source>
        <translation>trwa sprawdzanie klucza…</translation>
    </message>
    <message>
        <source>Waiting for the key: cancel</source>
        <translation>Oczekiwanie na klucz: anuluj</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>by</source>
        <translation>przez</translation>
    </message>
    <message>
        <source>name only, not verified</source>
        <translation>samo nazwisko, niesprawdzone</translation>
    </message>
    <message>
        <source>An OpenPGP key of yours, from gpg&apos;s key ring or a card: it verifies the name</source>
        <translation>Twój klucz OpenPGP z pęku kluczy gpg lub z karty: potwierdza nazwisko</translation>
    </message>
    <message>
        <source>The results are being computed</source>
        <translation>Trwa obliczanie wyników</translation>
    </message>
    <message>
        <source>%1 (key …%2)</source>
        <translation>%1 (klucz …%2)</translation>
    </message>
    <message>
        <source>✗ Audit trail: %1</source>
        <translation>✗ Dziennik zmian: %1</translation>
    </message>
    <message>
        <source>The clock of this machine stands before the last entry of the audit trail (%1): what is signed now would seem older.</source>
        <translation>Zegar tego komputera stoi przed ostatnim wpisem dziennika zmian (%1): to, co się teraz podpisze, wydawałoby się starsze.</translation>
    </message>
    <message>
        <source>this swing has been changed in another window or by another program since it was shown here; nothing was done, look at it again</source>
        <translation>ten pomiar zmieniono w innym oknie lub w innym programie, odkąd go tu pokazano; niczego nie zrobiono, obejrzyj go jeszcze raz</translation>
    </message>
    <message>
        <source>how the day is known</source>
        <translation>skąd znany jest dzień</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SitesPage</name>
    <message>
        <source>&amp;New base</source>
        <translation>&amp;Nowa baza</translation>
    </message>
    <message>
        <source>Variation from the &amp;model, today</source>
        <translation>Deklinacja z &amp;modelu, dziś</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nazwa:</translation>
    </message>
    <message>
        <source>a base must have a name</source>
        <translation>baza musi mieć nazwę</translation>
    </message>
    <message>
        <source>Owner:</source>
        <translation>Właściciel:</translation>
    </message>
    <message>
        <source>Latitude:</source>
        <translation>Szerokość geogr.:</translation>
    </message>
    <message>
        <source>Longitude:</source>
        <translation>Długość geogr.:</translation>
    </message>
    <message>
        <source>Elevation (m):</source>
        <translation>Wzniesienie (m):</translation>
    </message>
    <message>
        <source>Variation (°, E +):</source>
        <translation>Deklinacja (°, E +):</translation>
    </message>
    <message>
        <source>Variation by:</source>
        <translation>Deklinacja według:</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>class %1: within %2° (%3)</source>
        <translation>klasa %1: w granicach %2° (%3)</translation>
    </message>
    <message>
        <source>Class:</source>
        <translation>Klasa:</translation>
    </message>
    <message>
        <source>Certificate:</source>
        <translation>Świadectwo:</translation>
    </message>
    <message>
        <source>Valid to:</source>
        <translation>Ważne do:</translation>
    </message>
    <message>
        <source>Lines painted with (°, E +):</source>
        <translation>Linie namalowano przy (°, E +):</translation>
    </message>
    <message>
        <source>Painted on:</source>
        <translation>Namalowano:</translation>
    </message>
    <message>
        <source>Surveyed on:</source>
        <translation>Pomierzono:</translation>
    </message>
    <message>
        <source>Surveyed by:</source>
        <translation>Pomierzył:</translation>
    </message>
    <message>
        <source>Surveyed with:</source>
        <translation>Pomierzono przyrządem:</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <source>● may be used today</source>
        <translation>● można dziś użyć</translation>
    </message>
    <message>
        <source>▲ not to be used today: %1</source>
        <translation>▲ dziś nie używać: %1</translation>
    </message>
    <message>
        <source>Painted lines: the variation is %1° today, so that %2° is to be added to what a line says.</source>
        <translation>Linie namalowane: deklinacja wynosi dziś %1°, więc do opisu linii należy dodać %2°.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>new base</source>
        <translation>nowa baza</translation>
    </message>
    <message>
        <source>variation</source>
        <translation>deklinacja</translation>
    </message>
    <message>
        <source>Compass &amp;bases</source>
        <translation>&amp;Bazy dewiacyjne</translation>
    </message>
    <message>
        <source>Ctrl+Alt+B</source>
        <translation>Ctrl+Alt+B</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; expected metres, degrees or nT</source>
        <translation>„%1” nie jest liczbą; oczekiwano metrów, stopni lub nT</translation>
    </message>
    <message>
        <source>a point of a survey has a declination or a total field</source>
        <translation>punkt pomiaru ma deklinację lub pole całkowite</translation>
    </message>
    <message>
        <source>east (m)</source>
        <translation>wschód (m)</translation>
    </message>
    <message>
        <source>north (m)</source>
        <translation>północ (m)</translation>
    </message>
    <message>
        <source>height (m)</source>
        <translation>wysokość (m)</translation>
    </message>
    <message>
        <source>declination (°, E +)</source>
        <translation>deklinacja (°, E +)</translation>
    </message>
    <message>
        <source>total field (nT)</source>
        <translation>pole całkowite (nT)</translation>
    </message>
    <message>
        <source>From the centre of the base. Paste (Ctrl+V) takes columns from a spreadsheet</source>
        <translation>Od środka bazy. Wklejenie (Ctrl+V) przyjmuje kolumny z arkusza</translation>
    </message>
    <message>
        <source>Declination %1° to %2°, mean %3°, range %4′ of %5 points.</source>
        <translation>Deklinacja %1° do %2°, średnia %3°, rozstęp %4′ z punktów: %5.</translation>
    </message>
    <message>
        <source>Total field %1 to %2 nT, mean %3, range %4 nT.</source>
        <translation>Pole całkowite %1 do %2 nT, średnie %3, rozstęp %4 nT.</translation>
    </message>
    <message>
        <source>Half of that range turns a needle by %1° at most.</source>
        <translation>Połowa tego rozstępu obraca igłę najwyżej o %1°.</translation>
    </message>
    <message>
        <source>Meets no class.</source>
        <translation>Nie spełnia żadnej klasy.</translation>
    </message>
    <message>
        <source>Meets class %1.</source>
        <translation>Spełnia klasę %1.</translation>
    </message>
    <message>
        <source>Range within 12′ (MIL-STD-765A, per CNATRAINST 11130.1D).</source>
        <translation>Rozstęp w granicach 12′ (MIL-STD-765A, wg CNATRAINST 11130.1D).</translation>
    </message>
    <message>
        <source>Range beyond 12′ (MIL-STD-765A, per CNATRAINST 11130.1D).</source>
        <translation>Rozstęp powyżej 12′ (MIL-STD-765A, wg CNATRAINST 11130.1D).</translation>
    </message>
    <message>
        <source>Row %1 is not stored yet: %2</source>
        <translation>Wiersz %1 jeszcze niezapisany: %2</translation>
    </message>
    <message>
        <source>survey</source>
        <translation>pomiar</translation>
    </message>
    <message>
        <source>Line %1 of what is pasted: %2</source>
        <translation>Wiersz %1 wklejanych danych: %2</translation>
    </message>
    <message>
        <source>Compass bases</source>
        <translation>Bazy dewiacyjne</translation>
    </message>
    <message>
        <source>Compass bases: place, class and certificate, the lines that are painted there, and the survey. Paste the survey&apos;s points from a spreadsheet with Ctrl+V: whether the base is fit, and for what, follows.</source>
        <translation>Bazy dewiacyjne: położenie, klasa i świadectwo, namalowane linie oraz pomiar. Punkty pomiaru wklej z arkusza przez Ctrl+V: wyniknie, czy i do czego baza się nadaje.</translation>
    </message>
    <message>
        <source>&amp;Remove this base</source>
        <translation>&amp;Usuń tę bazę</translation>
    </message>
    <message>
        <source>removal of %1</source>
        <translation>usunięcie %1</translation>
    </message>
    <message>
        <source>New &amp;base…</source>
        <translation>Nowa &amp;baza…</translation>
    </message>
    <message>
        <source>Remove this base</source>
        <translation>Usuwanie bazy</translation>
    </message>
    <message>
        <source>%1 points were added to the %2 of the survey before. Ctrl+Z takes them out.</source>
        <translation>Dodano %1 punktów do %2 dotychczasowego pomiaru. Ctrl+Z je usuwa.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SlipWords</name>
    <message>
        <source>Look again: most likely the wrong row, as it fits %1 (%2)</source>
        <translation>Sprawdź ponownie: najpewniej niewłaściwy wiersz, bo pasuje do %1 (%2)</translation>
    </message>
    <message>
        <source>%1 in the magnetic heading</source>
        <translation>%1 w kursie magnetycznym</translation>
    </message>
    <message>
        <source>Look again: most likely %1, %2 meant (%3)</source>
        <translation>Sprawdź ponownie: najpewniej %1, miało być %2 (%3)</translation>
    </message>
    <message>
        <source>on %1 magnetic the compass reads %2; %3 ± %4° is expected.</source>
        <translation>na kursie magnetycznym %1 busola wskazuje %2; oczekiwano %3 ± %4°.</translation>
    </message>
    <message>
        <source>Look again: no usual slip explains it</source>
        <translation>Sprawdź ponownie: nie tłumaczy tego żadna zwykła pomyłka</translation>
    </message>
    <message>
        <source>on %1 magnetic the compass reads %2.</source>
        <translation>na kursie magnetycznym %1 busola wskazuje %2.</translation>
    </message>
    <message>
        <source>one of the readings on %1 magnetic may be misread (%2); these readings cannot tell which: look at them again</source>
        <translation>jeden z odczytów na kursach magnetycznych %1 może być błędny (%2); te odczyty nie mówią, który: sprawdź je ponownie</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>magnetic %1 is %2° off its nominal heading %3: is it this row&apos;s?</source>
        <translation>magnetyczny %1 odbiega o %2° od zadanego kursu %3: czy należy do tego wiersza?</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SmithTermsPanel</name>
    <message>
        <source>Coefficients and the terms that they come from</source>
        <translation>Współczynniki i składniki, z których powstają</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>dokładne</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>przybliżone</translation>
    </message>
    <message>
        <source>comes from</source>
        <translation>pochodzi z</translation>
    </message>
    <message>
        <source>What a level swing can tell and what it cannot</source>
        <translation>Co pomiar w poziomie może powiedzieć, a czego nie</translation>
    </message>
    <message>
        <source>What a level swing here can tell</source>
        <translation>Co może tu powiedzieć pomiar w poziomie</translation>
    </message>
    <message>
        <source>No coefficients: %1.</source>
        <translation>Brak współczynników: %1.</translation>
    </message>
    <message>
        <source>λ = %1: a level compass is held by %2 % of H on the mean.</source>
        <translation>λ = %1: busolę w poziomie utrzymuje średnio %2 % H.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SpectrumChart</name>
    <message>
        <source>noise floor (95 %)</source>
        <translation>poziom szumu (95 %)</translation>
    </message>
    <message>
        <source>order of the harmonic (per turn)</source>
        <translation>rząd harmonicznej (na obrót)</translation>
    </message>
    <message>
        <source>amplitude (°)</source>
        <translation>amplituda (°)</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplituda</translation>
    </message>
    <message>
        <source>cosine only</source>
        <translation>tylko cosinus</translation>
    </message>
    <message>
        <source>not resolved by these headings</source>
        <translation>te kursy nie rozróżniają</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::StartPage</name>
    <message>
        <source>Compass swings, from the readings to the correction card</source>
        <translation>Pomiary dewiacji busol: od odczytów do tablicy dewiacji</translation>
    </message>
    <message>
        <source>This database is empty. How do you want to begin?</source>
        <translation>Ta baza danych jest pusta. Jak chcesz zacząć?</translation>
    </message>
    <message>
        <source>&amp;Open the demonstration fleet</source>
        <translation>&amp;Otwórz flotę pokazową</translation>
    </message>
    <message>
        <source>Invented aircraft with several years of swings, to look around in. Marked as demonstration data everywhere.</source>
        <translation>Zmyślone statki powietrzne z pomiarami z kilku lat, do obejrzenia. Wszędzie oznaczone jako dane pokazowe.</translation>
    </message>
    <message>
        <source>&amp;Import a swing</source>
        <translation>&amp;Wczytaj pomiar dewiacji</translation>
    </message>
    <message>
        <source>A CSV of readings, an exchange file (.lubberline.json), or a report PDF of Lubberline. You can also drop it on the window.</source>
        <translation>Plik CSV z odczytami, plik wymiany (.lubberline.json) albo sprawozdanie PDF programu Lubberline. Można też upuścić go na okno.</translation>
    </message>
    <message>
        <source>Start a &amp;new swing</source>
        <translation>Zacznij &amp;nowy pomiar dewiacji</translation>
    </message>
    <message>
        <source>Name the aircraft and its compass, then type the readings: curve and coefficients follow every key.</source>
        <translation>Podaj statek powietrzny i jego busolę, potem wpisuj odczyty: krzywa i współczynniki nadążają za każdym klawiszem.</translation>
    </message>
    <message>
        <source>The database is empty. Look around in the demonstration fleet, import a file, or name an aircraft and type its first swing.</source>
        <translation>Baza jest pusta. Rozejrzyj się we flocie pokazowej, zaimportuj plik albo nazwij statek powietrzny i wpisz jego pierwszy pomiar.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::StationStrip</name>
    <message>
        <source>%1: skipped, %2</source>
        <translation>%1: pominięto, %2</translation>
    </message>
    <message>
        <source>%1: void, to be read again</source>
        <translation>%1: nieważny, do ponownego odczytu</translation>
    </message>
    <message>
        <source>%1: compass read %2</source>
        <translation>%1: busola wskazała %2</translation>
    </message>
    <message>
        <source>%1: now</source>
        <translation>%1: teraz</translation>
    </message>
    <message>
        <source>%1: to come</source>
        <translation>%1: przed nami</translation>
    </message>
    <message>
        <source>Headings of this swing</source>
        <translation>Kursy tego pomiaru</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SurfaceChart</name>
    <message>
        <source>There is no map yet.</source>
        <translation>Mapy jeszcze nie ma.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SurfacePlot</name>
    <message>
        <source>Surface</source>
        <translation>Powierzchnia</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SurveyDrawing</name>
    <message>
        <source>%1′</source>
        <translation>%1′</translation>
    </message>
    <message>
        <source>%1 nT</source>
        <translation>%1 nT</translation>
    </message>
    <message>
        <source>No survey yet: type or paste its points into the table</source>
        <translation>Brak jeszcze pomiaru: wpisz lub wklej jego punkty do tabeli</translation>
    </message>
    <message>
        <source>declination − mean (′), east +; true north up</source>
        <translation>deklinacja − średnia (′), wschodnia +; północ geograficzna w górę</translation>
    </message>
    <message>
        <source>total field − mean (nT); true north up</source>
        <translation>pole całkowite − średnie (nT); północ geograficzna w górę</translation>
    </message>
    <message>
        <source>10 m</source>
        <translation>10 m</translation>
    </message>
    <message>
        <source>%1 m east, %2 m north</source>
        <translation>%1 m na wschód, %2 m na północ</translation>
    </message>
    <message>
        <source>
declination %1° (E +)</source>
        <translation>
deklinacja %1° (E +)</translation>
    </message>
    <message>
        <source>
total field %1 nT</source>
        <translation>
pole całkowite %1 nT</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SwingEditor</name>
    <message>
        <source>a new row</source>
        <translation>nowy wiersz</translation>
    </message>
    <message>
        <source>This database can only be read.</source>
        <translation>Tę bazę danych można tylko czytać.</translation>
    </message>
    <message>
        <source>This swing is signed: it is frozen.</source>
        <translation>Ten pomiar jest podpisany: nie można go zmienić.</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 na kursie %2</translation>
    </message>
    <message>
        <source>removal of the row on %1</source>
        <translation>usunięcie wiersza na kursie %1</translation>
    </message>
    <message>
        <source>removal of %1 rows</source>
        <translation>usunięcie wierszy: %1</translation>
    </message>
    <message>
        <source>layout of %1 headings</source>
        <translation>rozłożenie kursów: %1</translation>
    </message>
    <message>
        <source>completion</source>
        <translation>zakończenie</translation>
    </message>
    <message>
        <source>exclusion</source>
        <translation>pominięcie</translation>
    </message>
    <message>
        <source>inclusion</source>
        <translation>przywrócenie</translation>
    </message>
    <message>
        <source>it is being computed</source>
        <translation>trwa obliczanie</translation>
    </message>
    <message>
        <source>This swing is complete. To change a reading, open it again.</source>
        <translation>Ta dewiacja jest kompletna. Aby zmienić odczyt, otwórz ją ponownie.</translation>
    </message>
    <message>
        <source>This swing is frozen as a signed one, but nobody&apos;s signature is there: it is printed as not signed. Amend it to sign it.</source>
        <translation>Ten pomiar jest zamrożony jako podpisany, ale niczyjego podpisu nie ma: drukuje się jako niepodpisany. Aby go podpisać, zmień go w nowym wydaniu.</translation>
    </message>
    <message>
        <source>This swing is frozen as a signed one, but its signatures do not stand over what it says now: it is printed as not signed. Amend it to sign it.</source>
        <translation>Ten pomiar jest zamrożony jako podpisany, ale jego podpisy nie obejmują tego, co teraz zawiera: drukuje się go jako niepodpisany. Aby go podpisać, sporządzić poprawkę.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SwingFiles</name>
    <message>
        <source>No report: %1</source>
        <translation>Brak sprawozdania: %1</translation>
    </message>
    <message>
        <source>Write report</source>
        <translation>Zapisz sprawozdanie</translation>
    </message>
    <message>
        <source>PDF with the data attached (*.pdf);;HTML (*.html);;Readings (*.csv);;Results (*.json)</source>
        <translation>PDF z dołączonymi danymi (*.pdf);;HTML (*.html);;Odczyty (*.csv);;Wyniki (*.json)</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Zapisano sprawozdanie: %1</translation>
    </message>
    <message>
        <source>No card: %1</source>
        <translation>Brak tablicy dewiacji: %1</translation>
    </message>
    <message>
        <source>Write correction card</source>
        <translation>Zapisz tablicę dewiacji</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Card written: %1</source>
        <translation>Zapisano tablicę dewiacji: %1</translation>
    </message>
    <message>
        <source>Write a blank job card</source>
        <translation>Zapisz czystą kartę pracy</translation>
    </message>
    <message>
        <source>Job card written: %1</source>
        <translation>Zapisano kartę pracy: %1</translation>
    </message>
    <message>
        <source>Write a sheet in DD 1613 style</source>
        <translation>Zapisz arkusz w układzie DD 1613</translation>
    </message>
    <message>
        <source>Sheet written: %1</source>
        <translation>Zapisano arkusz: %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SwingPage</name>
    <message>
        <source>P&amp;articulars</source>
        <translation>&amp;Dane pomiaru</translation>
    </message>
    <message>
        <source>Si&amp;gn</source>
        <translation>Pod&amp;pis</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Odczyty</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>Co to znaczy</translation>
    </message>
    <message>
        <source> · DEMONSTRATION</source>
        <translation> · DANE POKAZOWE</translation>
    </message>
    <message>
        <source>Mark &amp;complete</source>
        <translation>&amp;Zakończ pomiar</translation>
    </message>
    <message>
        <source>Open &amp;again…</source>
        <translation>Otwórz &amp;ponownie…</translation>
    </message>
    <message>
        <source>After these readings A = %1° was taken out by turning the compass: plots, coefficients and card are as it stands since. </source>
        <translation>Po tych odczytach A = %1° usunięto przez obrót busoli: wykresy, współczynniki i tablica dotyczą jej obecnego ustawienia. </translation>
    </message>
    <message>
        <source>No result yet: %1.</source>
        <translation>Nie ma jeszcze wyniku: %1.</translation>
    </message>
    <message>
        <source>◉ %1</source>
        <translation>◉ %1</translation>
    </message>
    <message>
        <source>Enter: next cell · = accepts the nominal heading · deviation may be typed as 3.5W</source>
        <translation>Enter: następna komórka · = przyjmuje kurs nominalny · dewiację można wpisać jako 3.5W</translation>
    </message>
    <message>
        <source>new row</source>
        <translation>nowy wiersz</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>wiersz %1</translation>
    </message>
    <message>
        <source>removal of the swing of %1</source>
        <translation>usunięcie pomiaru z %1</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Sprawozdanie…</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Print preview of the report…</source>
        <translation>Podgląd &amp;wydruku sprawozdania…</translation>
    </message>
    <message>
        <source>Correction &amp;card, every 30°…</source>
        <translation>&amp;Tablica dewiacji co 30°…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Correction card, every &amp;45°…</source>
        <translation>Tablica dewiacji co &amp;45°…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Print preview of the car&amp;d…</source>
        <translation>Podgląd wydruku ta&amp;blicy…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>&amp;Job card to carry out…</source>
        <translation>&amp;Karta pracy do wypełnienia…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+J</source>
        <translation>Ctrl+Alt+J</translation>
    </message>
    <message>
        <source>Sheet in DD &amp;1613 style…</source>
        <translation>Arkusz w układzie DD &amp;1613…</translation>
    </message>
    <message>
        <source>%1 points, every %2°</source>
        <translation>%1 punktów, co %2°</translation>
    </message>
    <message>
        <source>&amp;Lay out nominal headings</source>
        <translation>&amp;Rozłóż kursy nominalne</translation>
    </message>
    <message>
        <source>&amp;Accept the nominal heading</source>
        <translation>Przyjmij kurs &amp;nominalny</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>&amp;Insert a row above</source>
        <translation>Wstaw w&amp;iersz powyżej</translation>
    </message>
    <message>
        <source>Ctrl+Ins</source>
        <translation>Ctrl+Ins</translation>
    </message>
    <message>
        <source>&amp;Delete the selected rows</source>
        <translation>&amp;Usuń zaznaczone wiersze</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>&amp;Exclude the reading…</source>
        <translation>Pomiń &amp;odczyt…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Mark &amp;complete, or open again</source>
        <translation>&amp;Zakończ albo otwórz ponownie</translation>
    </message>
    <message>
        <source>Ctrl+Return</source>
        <translation>Ctrl+Return</translation>
    </message>
    <message>
        <source>&amp;Sign or amend</source>
        <translation>Po&amp;dpisz albo zmień</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Remove this draft swing</source>
        <translation>Usuń ten szkic po&amp;miaru</translation>
    </message>
    <message>
        <source>Go to the &amp;readings</source>
        <translation>Przejdź do od&amp;czytów</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Go to the &amp;aircraft of this swing</source>
        <translation>Przejdź do statku powietrzne&amp;go</translation>
    </message>
    <message>
        <source>Ctrl+U</source>
        <translation>Ctrl+U</translation>
    </message>
    <message>
        <source>&amp;Polar plot</source>
        <translation>Wykres &amp;biegunowy</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Krzywa</translation>
    </message>
    <message>
        <source>&amp;Spectrum</source>
        <translation>&amp;Widmo</translation>
    </message>
    <message>
        <source>C&amp;omponents</source>
        <translation>&amp;Składowe</translation>
    </message>
    <message>
        <source>Ca&amp;rd</source>
        <translation>&amp;Tablica</translation>
    </message>
    <message>
        <source>Correction card on the page, in &amp;other steps</source>
        <translation>Tablica dewiacji na stronie, &amp;inne kroki</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Pomiar</translation>
    </message>
    <message>
        <source>computing %p %</source>
        <translation>obliczanie %p %</translation>
    </message>
    <message>
        <source>Computing the results</source>
        <translation>Obliczanie wyników</translation>
    </message>
    <message>
        <source>The results are being computed</source>
        <translation>Trwa obliczanie wyników</translation>
    </message>
    <message>
        <source>Being computed anew; of the readings before the last change: %1</source>
        <translation>Trwa ponowne obliczanie; z odczytów przed ostatnią zmianą: %1</translation>
    </message>
    <message>
        <source>Not stored: %1 (Esc: the stored value)</source>
        <translation>Niezapisane: %1 (Esc: wartość zapisana)</translation>
    </message>
    <message>
        <source>Type the magnetic heading, Enter, the compass reading, Enter: the next row follows. Angles as 3.25, 3.25W, 3°15&apos;W, 3 15 W; decimal point or comma.
In the deviation column, W and E (or a sign) give the compass heading. = or Ctrl+D takes the nominal heading as read. Delete empties a cell.
A text that is refused stands beside the stored value; Escape puts that back. A click or Enter on a coefficient opens where it comes from.
Cells and blocks are copied, cut and pasted as in a spreadsheet (Ctrl+C, X, V), with or without a first row of headings.
Ctrl+Z undoes everything, across swings. Ctrl+E leaves a reading out, with a reason that stays on the record.</source>
        <translation>Wpisz kurs magnetyczny, Enter, wskazanie busoli, Enter: następuje kolejny wiersz. Kąty jako 3.25, 3.25W, 3°15&apos;W, 3 15 W; kropka lub przecinek dziesiętny.
W kolumnie dewiacji W i E (albo znak) dają kurs kompasowy. = lub Ctrl+D bierze kurs zadany jako odczytany. Delete opróżnia komórkę.
Odrzucony tekst stoi obok zapisanej wartości; Escape ją przywraca. Kliknięcie lub Enter na współczynniku otwiera jego pochodzenie.
Komórki i bloki kopiuje się, wycina i wkleja jak w arkuszu (Ctrl+C, X, V), z pierwszym wierszem nagłówków lub bez.
Ctrl+Z cofa wszystko, także między pomiarami. Ctrl+E pomija odczyt, z powodem, który zostaje w zapisie.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written</source>
        <translation>Anulowano: niczego nie zapisano</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SwingParticulars</name>
    <message>
        <source>Date:</source>
        <translation>Data:</translation>
    </message>
    <message>
        <source>year-month-day, UTC</source>
        <translation>rok-miesiąc-dzień, UTC</translation>
    </message>
    <message>
        <source>Kind:</source>
        <translation>Rodzaj:</translation>
    </message>
    <message>
        <source>Stage:</source>
        <translation>Etap:</translation>
    </message>
    <message>
        <source>Site:</source>
        <translation>Miejsce:</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>Variation:</source>
        <translation>Deklinacja:</translation>
    </message>
    <message>
        <source>Radio:</source>
        <translation>Radio:</translation>
    </message>
    <message>
        <source>Engines:</source>
        <translation>Silniki:</translation>
    </message>
    <message>
        <source>Electrics:</source>
        <translation>Odbiorniki el.:</translation>
    </message>
    <message>
        <source>Other:</source>
        <translation>Inne:</translation>
    </message>
    <message>
        <source>Reason:</source>
        <translation>Powód:</translation>
    </message>
    <message>
        <source>Note:</source>
        <translation>Uwaga:</translation>
    </message>
    <message>
        <source>Datum:</source>
        <translation>Wzorzec:</translation>
    </message>
    <message>
        <source>Datum s/n:</source>
        <translation>Nr seryjny wzorca:</translation>
    </message>
    <message>
        <source>Calibration due:</source>
        <translation>Wzorcowanie do:</translation>
    </message>
    <message>
        <source>Datum read by:</source>
        <translation>Wzorzec odczytał:</translation>
    </message>
    <message>
        <source>Compass read by:</source>
        <translation>Busolę odczytał:</translation>
    </message>
    <message>
        <source>Adjuster:</source>
        <translation>Kompensował:</translation>
    </message>
    <message>
        <source>Inspector:</source>
        <translation>Kontroler:</translation>
    </message>
    <message>
        <source>Shared error:</source>
        <translation>Błąd wspólny:</translation>
    </message>
    <message>
        <source>Standard errors that all readings share and no scatter shows, in degrees: of the datum, the variation, a log&apos;s delay and wind. One figure is A&apos;s; else letters, as in A 0.6 B 0.2. They widen what is said of the coefficients</source>
        <translation>Błędy standardowe, wspólne wszystkim odczytom, których nie pokazuje żaden rozrzut, w stopniach: wzorca, deklinacji, opóźnienia zapisu i wiatru. Jedna liczba dotyczy A; inaczej litery, jak A 0.6 B 0.2. Poszerzają to, co mówi się o współczynnikach</translation>
    </message>
    <message>
        <source>as 3.5E</source>
        <translation>np. 3.5E</translation>
    </message>
    <message>
        <source>as 0.5</source>
        <translation>np. 0.5</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::SwingWords</name>
    <message>
        <source>%1 within %2°</source>
        <translation>%1 w granicach %2°</translation>
    </message>
    <message>
        <source>%1 %2° exceeds the %3° allowed</source>
        <translation>%1 %2° przekracza dopuszczalne %3°</translation>
    </message>
    <message>
        <source>No limits are set for this compass: choose them on the aircraft&apos;s page (Ctrl+U).</source>
        <translation>Dla tej busoli nie ustalono wartości dopuszczalnych: wybierz je na stronie statku powietrznego (Ctrl+U).</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>dewiacja</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>rozpiętość</translation>
    </message>
    <message>
        <source>In limits</source>
        <translation>W granicach</translation>
    </message>
    <message>
        <source>OUT OF LIMITS</source>
        <translation>POZA GRANICAMI</translation>
    </message>
    <message>
        <source>%1: %2 (%3).</source>
        <translation>%1: %2 (%3).</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source> A reading is suspect: look again before these figures are used.</source>
        <translation> Jeden z odczytów jest wątpliwy: sprawdź go, zanim użyjesz tych wartości.</translation>
    </message>
    <message>
        <source>Largest deviation %1 at %2 magnetic. </source>
        <translation>Największa dewiacja %1 na kursie magnetycznym %2. </translation>
    </message>
    <message>
        <source> Not read: %1 (compass).</source>
        <translation> Nie odczytano: %1 (busola).</translation>
    </message>
    <message>
        <source>NOT KNOWN: within limits where it was read, but over %1° of the circle nothing was read.</source>
        <translation>NIE WIADOMO: w normie tam, gdzie odczytano, ale na %1° koła niczego nie odczytano.</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::Transfers</name>
    <message>
        <source>%1: swings imported: %2</source>
        <translation>%1: wczytano pomiarów: %2</translation>
    </message>
    <message>
        <source>, already there: %1</source>
        <translation>, były już wcześniej: %1</translation>
    </message>
    <message>
        <source>%1: swings exported: %2.</source>
        <translation>%1: zapisano pomiarów: %2.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::WindsPage</name>
    <message>
        <source>Deviation from &amp;winds…</source>
        <translation>Dewiacja z &amp;wiatrów…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Write the &amp;tables to upload…</source>
        <translation>Zapisz &amp;tabele do wgrania…</translation>
    </message>
    <message>
        <source>Write the &amp;report as PDF…</source>
        <translation>Zapisz &amp;sprawozdanie jako PDF…</translation>
    </message>
    <message>
        <source>An aircraft&apos;s wind is wrong across its track by airspeed times the error of its heading. Each report beside a reference wind gives that error: e = dir(Vg − reported wind) − dir(Vg − reference wind) = offset + a sin ψ′ + b cos ψ′; deviation is −e (N. Jacobs, D. Mulally, A. Anderson, 2014, equations 1 and 4 to 7). Standard errors are by flights, since reports of a flight share the error of the reference; a constant error of the reference looks like B or C. Tables of eight points are enlarged by 1.05 (the paper), 1.0530 (so that straight lines hold the sine) or not.</source>
        <translation>Wiatr statku powietrznego jest błędny w poprzek jego drogi o prędkość powietrzną razy błąd kursu. Każdy meldunek obok wiatru odniesienia daje ten błąd: e = kier(Vg − wiatr meldowany) − kier(Vg − wiatr odniesienia) = przesunięcie + a sin ψ′ + b cos ψ′; dewiacja to −e (N. Jacobs, D. Mulally, A. Anderson, 2014, równania 1 i od 4 do 7). Błędy standardowe są według lotów, bo meldunki lotu dzielą błąd odniesienia; stały błąd odniesienia wygląda jak B lub C. Tabele ośmiu punktów powiększa się o 1.05 (praca), 1.0530 (by proste oddały sinusoidę) albo nie.</translation>
    </message>
    <message>
        <source>&amp;Open wind reports…</source>
        <translation>&amp;Otwórz meldunki o wietrze…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Reports over heading</source>
        <translation>Meldunki według kursu</translation>
    </message>
    <message>
        <source>Headings flown</source>
        <translation>Przeleciane kursy</translation>
    </message>
    <message>
        <source>Reading… %1 %</source>
        <translation>Wczytywanie… %1 %</translation>
    </message>
    <message>
        <source>Deviation from winds</source>
        <translation>Dewiacja z wiatrów</translation>
    </message>
    <message>
        <source>Open a CSV of wind reports beside a reference wind: ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt, ref_wind_from_deg; aircraft, flight, time_utc, position.</source>
        <translation>Otwórz plik CSV z meldunkami o wietrze obok wiatru odniesienia: ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt, ref_wind_from_deg; aircraft, flight, time_utc, położenie.</translation>
    </message>
    <message>
        <source>table × 1.05 (paper)</source>
        <translation>tabela × 1.05 (praca)</translation>
    </message>
    <message>
        <source>table × 1.0530 (exact)</source>
        <translation>tabela × 1.0530 (dokładnie)</translation>
    </message>
    <message>
        <source>table × 1 (none)</source>
        <translation>tabela × 1 (bez)</translation>
    </message>
    <message>
        <source>winds as the file says</source>
        <translation>wiatry, jak mówi plik</translation>
    </message>
    <message>
        <source>reported winds: towards</source>
        <translation>wiatry meldowane: dokąd</translation>
    </message>
    <message>
        <source>reference winds: towards</source>
        <translation>wiatry odniesienia: dokąd</translation>
    </message>
    <message>
        <source>both: towards</source>
        <translation>oba: dokąd</translation>
    </message>
    <message>
        <source>winds: from (believed)</source>
        <translation>wiatry: skąd (uznane)</translation>
    </message>
    <message>
        <source>units as the file says</source>
        <translation>jednostki, jak mówi plik</translation>
    </message>
    <message>
        <source>reported winds in m/s</source>
        <translation>wiatry meldowane w m/s</translation>
    </message>
    <message>
        <source>reference winds in m/s</source>
        <translation>wiatry odniesienia w m/s</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Statek powietrzny</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>Loty</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Użyto</translation>
    </message>
    <message>
        <source>In phase °</source>
        <translation>W fazie °</translation>
    </message>
    <message>
        <source>Quadrature °</source>
        <translation>Kwadratura °</translation>
    </message>
    <message>
        <source>Offset °</source>
        <translation>Przesunięcie °</translation>
    </message>
    <message>
        <source>± °, 1 se</source>
        <translation>± °, 1 błąd std.</translation>
    </message>
    <message>
        <source>Across, kt</source>
        <translation>W poprzek, w</translation>
    </message>
    <message>
        <source>After, kt</source>
        <translation>Po, w</translation>
    </message>
    <message>
        <source>Changed after</source>
        <translation>Zmiana po</translation>
    </message>
    <message>
        <source>Held against</source>
        <translation>Porównano z</translation>
    </message>
    <message>
        <source>held against (group or aircraft)</source>
        <translation>porównaj z (grupa lub statek)</translation>
    </message>
    <message>
        <source>Aircraft whose headings are held to be right, as by laser gyros: a name of the column group, or of an aircraft. What they have in common is the error of the reference wind.</source>
        <translation>Statki powietrzne, których kursy uznaje się za dobre, np. z żyroskopów laserowych: nazwa z kolumny group albo statku. To, co mają wspólne, jest błędem wiatru odniesienia.</translation>
    </message>
    <message>
        <source>Open wind reports to see an aircraft&apos;s deviation over heading.</source>
        <translation>Otwórz meldunki o wietrze, aby zobaczyć dewiację statku powietrznego według kursu.</translation>
    </message>
    <message>
        <source>The headings that were flown stand here.</source>
        <translation>Tu stoją przeleciane kursy.</translation>
    </message>
    <message>
        <source>Open wind reports</source>
        <translation>Otwieranie meldunków o wietrze</translation>
    </message>
    <message>
        <source>Wind CSV (*.csv);;All files (*)</source>
        <translation>Wind CSV (*.csv);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Czytanie %1 …</translation>
    </message>
    <message>
        <source>%1: %2 reports, %3 used.</source>
        <translation>%1: meldunków %2, użyto %3.</translation>
    </message>
    <message>
        <source>Across the track %1 is %2 times as far off as %3%4.</source>
        <translation>W poprzek drogi %1 odbiega %2 razy tyle co %3%4.</translation>
    </message>
    <message>
        <source>, %1 times once corrected</source>
        <translation>, po poprawieniu %1 razy</translation>
    </message>
    <message>
        <source>Nothing to write yet; open wind reports first</source>
        <translation>Nie ma jeszcze czego zapisać; najpierw otwórz meldunki o wietrze</translation>
    </message>
    <message>
        <source>Write the tables</source>
        <translation>Zapisywanie tabel</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisywanie sprawozdania</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::WorldFieldChart</name>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>The field is being computed.</source>
        <translation>Pole jest obliczane.</translation>
    </message>
    <message>
        <source>equirectangular, equal scales</source>
        <translation>odwzorowanie walcowe równoodległościowe, skale równe</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::WorldFieldPlot</name>
    <message>
        <source>World map</source>
        <translation>Mapa świata</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::WorldFieldText</name>
    <message>
        <source>declination</source>
        <translation>deklinacja</translation>
    </message>
    <message>
        <source>inclination</source>
        <translation>inklinacja</translation>
    </message>
    <message>
        <source>horizontal field H</source>
        <translation>pole poziome H</translation>
    </message>
    <message>
        <source>vertical field Z</source>
        <translation>pole pionowe Z</translation>
    </message>
    <message>
        <source>total field F</source>
        <translation>pole całkowite F</translation>
    </message>
    <message>
        <source>°, east +</source>
        <translation>°, wschodnia +</translation>
    </message>
    <message>
        <source>°, down +</source>
        <translation>°, w dół +</translation>
    </message>
    <message>
        <source>nT, down +</source>
        <translation>nT, w dół +</translation>
    </message>
    <message>
        <source>nT</source>
        <translation>nT</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source> nT</source>
        <translation> nT</translation>
    </message>
    <message>
        <source>%1, %2: %3 %4</source>
        <translation>%1, %2: %3 %4</translation>
    </message>
</context>
<context>
    <name>lubberline::ui::YearsImportPage</name>
    <message>
        <source>Records of &amp;years…</source>
        <translation>Zapisy z &amp;lat…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+I</source>
        <translation>Ctrl+Alt+I</translation>
    </message>
    <message>
        <source>Swings of many years on paper, typed into one table: open it, say what each column is and what stands under the headings, and look at the first swings. Records whose sign the type&apos;s D speaks against are told, never turned. What was stored is undone as one step.</source>
        <translation>Papierowe pomiary z wielu lat, przepisane do jednej tabeli: otwórz ją, powiedz, czym jest każda kolumna i co stoi pod kursami, i obejrzyj pierwsze pomiary. Zapisy, przeciw których znakowi mówi D typu, są wymieniane, nigdy odwracane. To, co zapisano, cofa się jednym krokiem.</translation>
    </message>
    <message>
        <source>&amp;Open a table…</source>
        <translation>&amp;Otwórz tabelę…</translation>
    </message>
    <message>
        <source>&amp;Store these swings</source>
        <translation>&amp;Zapisz te pomiary</translation>
    </message>
    <message>
        <source>&amp;Undo this import</source>
        <translation>&amp;Cofnij to wczytanie</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>&amp;Anuluj</translation>
    </message>
    <message>
        <source>— what stands in their cells? —</source>
        <translation>— co stoi w ich komórkach? —</translation>
    </message>
    <message>
        <source>compass heading read</source>
        <translation>odczytany kurs kompasowy</translation>
    </message>
    <message>
        <source>magnetic heading read</source>
        <translation>kurs magnetyczny</translation>
    </message>
    <message>
        <source>deviation (magnetic − compass)</source>
        <translation>dewiacja (magnetyczny − kompasowy)</translation>
    </message>
    <message>
        <source>indication error (compass − magnetic)</source>
        <translation>błąd wskazania (kompasowy − magnetyczny)</translation>
    </message>
    <message>
        <source>magnetic headings</source>
        <translation>kursy magnetyczne</translation>
    </message>
    <message>
        <source>compass headings</source>
        <translation>kursy kompasowe</translation>
    </message>
    <message>
        <source>year-month-day</source>
        <translation>rok-miesiąc-dzień</translation>
    </message>
    <message>
        <source>day.month.year</source>
        <translation>dzień.miesiąc.rok</translation>
    </message>
    <message>
        <source>month/day/year</source>
        <translation>miesiąc/dzień/rok</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>stan zastany</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>stan końcowy</translation>
    </message>
    <message>
        <source>Records of years on paper</source>
        <translation>Zapisy z lat na papierze</translation>
    </message>
    <message>
        <source>A table (CSV) of many swings: a row a swing with a column for each heading, or a row a reading. Say what its columns are; nothing is stored before you have seen how the first swings look.</source>
        <translation>Tabela (CSV) wielu pomiarów: wiersz na pomiar z kolumną na każdy kurs albo wiersz na odczyt. Powiedz, czym są jej kolumny; nic nie jest zapisywane, zanim nie zobaczysz, jak wyglądają pierwsze pomiary.</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Kolumna</translation>
    </message>
    <message>
        <source>In the first rows</source>
        <translation>W pierwszych wierszach</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Co to jest</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Wiersz</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Aircraft</source>
        <translation>Statek powietrzny</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Busola</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Etap</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Odczyty</translation>
    </message>
    <message>
        <source>A (°)</source>
        <translation>A (°)</translation>
    </message>
    <message>
        <source>B (°)</source>
        <translation>B (°)</translation>
    </message>
    <message>
        <source>C (°)</source>
        <translation>C (°)</translation>
    </message>
    <message>
        <source>D (°)</source>
        <translation>D (°)</translation>
    </message>
    <message>
        <source>E (°)</source>
        <translation>E (°)</translation>
    </message>
    <message>
        <source>Largest (°)</source>
        <translation>Największa (°)</translation>
    </message>
    <message>
        <source>Under the headings stands</source>
        <translation>Pod kursami stoją</translation>
    </message>
    <message>
        <source>The columns are</source>
        <translation>Kolumny są</translation>
    </message>
    <message>
        <source>Dates are written</source>
        <translation>Daty są pisane</translation>
    </message>
    <message>
        <source>Where no column says it, the type is</source>
        <translation>Gdy nie mówi tego kolumna, typ to</translation>
    </message>
    <message>
        <source>the compass is</source>
        <translation>busola to</translation>
    </message>
    <message>
        <source>the stage is</source>
        <translation>etap to</translation>
    </message>
    <message>
        <source>the kind of swing is</source>
        <translation>rodzaj pomiaru to</translation>
    </message>
    <message>
        <source>A table of swings</source>
        <translation>Tabela pomiarów</translation>
    </message>
    <message>
        <source>Table (*.csv *.tsv *.txt)</source>
        <translation>Tabela (*.csv *.tsv *.txt)</translation>
    </message>
    <message>
        <source>heading %1°</source>
        <translation>kurs %1°</translation>
    </message>
    <message>
        <source>nothing known: kept as a note</source>
        <translation>nic znanego: zachowane jako uwaga</translation>
    </message>
    <message>
        <source>The whole table is read; nothing is stored yet…</source>
        <translation>Trwa czytanie całej tabeli; nic jeszcze nie jest zapisane…</translation>
    </message>
    <message>
        <source>The swings are stored…</source>
        <translation>Trwa zapisywanie pomiarów…</translation>
    </message>
    <message>
        <source>The import is undone…</source>
        <translation>Trwa cofanie wczytania…</translation>
    </message>
    <message>
        <source>Cancelled: nothing was changed.</source>
        <translation>Anulowano: niczego nie zmieniono.</translation>
    </message>
    <message>
        <source>Undone: %1 swings were taken out.</source>
        <translation>Cofnięto: wyjęto pomiarów %1.</translation>
    </message>
    <message>
        <source>No sign is suspect, and nothing else is to be told.</source>
        <translation>Żaden znak nie jest podejrzany i nie ma nic więcej do powiedzenia.</translation>
    </message>
    <message>
        <source>%1 swings with %2 readings; %3 aircraft and %4 compasses are new; %5 swings are there already. Nothing is stored yet.</source>
        <translation>Pomiarów %1 z odczytami %2; nowych statków powietrznych %3, busol %4; już zapisanych pomiarów %5. Nic jeszcze nie jest zapisane.</translation>
    </message>
    <message>
        <source>Stored: %1 swings with %2 readings; %3 aircraft and %4 compasses are new; %5 swings were there already.</source>
        <translation>Zapisano: pomiarów %1 z odczytami %2; nowych statków powietrznych %3, busol %4; już zapisanych było %5.</translation>
    </message>
    <message>
        <source>What the column %1 is</source>
        <translation>Czym jest kolumna %1</translation>
    </message>
</context>
<context>
    <name>ui</name>
    <message>
        <source>cancelled</source>
        <translation>anulowano</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>the calibration of %1 was due on %2</source>
        <translation>wzorcowanie przyrządu %1 było ważne do %2</translation>
    </message>
    <message>
        <source>cannot be imported: expected a name that ends in .csv (swing), .json (exchange) or .pdf (report)</source>
        <translation>nie daje się wczytać: oczekiwano nazwy kończącej się na .csv (pomiar), .json (wymiana) lub .pdf (sprawozdanie)</translation>
    </message>
    <message>
        <source>no place was found to keep it until the database can be written again</source>
        <translation>nie znaleziono miejsca, by to przechować do czasu, aż baza danych znów da się zapisywać</translation>
    </message>
    <message>
        <source>the swing is no longer there</source>
        <translation>tego pomiaru już nie ma</translation>
    </message>
    <message>
        <source>there is no sensor model &quot;%1&quot; any more</source>
        <translation>modelu czujnika „%1” już nie ma</translation>
    </message>
    <message>
        <source>there is no base %1 any more</source>
        <translation>kręgu dewiacyjnego %1 już nie ma</translation>
    </message>
    <message>
        <source>a swing (CSV), an exchange file (JSON) or a report (PDF)</source>
        <translation>pomiar (CSV), plik wymiany (JSON) albo raport (PDF)</translation>
    </message>
    <message>
        <source>from ahead: direct</source>
        <translation>z przodu: wprost</translation>
    </message>
    <message>
        <source>from ahead: reciprocal</source>
        <translation>z przodu: odwrotnie</translation>
    </message>
    <message>
        <source>zero %1°</source>
        <translation>zero %1°</translation>
    </message>
    <message>
        <source>true, less variation</source>
        <translation>rzeczywisty, pomniejszony o deklinację</translation>
    </message>
    <message>
        <source>track over ground (RMC, VTG)</source>
        <translation>kąt drogi nad ziemią (RMC, VTG)</translation>
    </message>
    <message>
        <source>true heading (HDT, THS)</source>
        <translation>kurs rzeczywisty (HDT, THS)</translation>
    </message>
    <message>
        <source>another magnetic heading (HDM, HDG)</source>
        <translation>inny kurs magnetyczny (HDM, HDG)</translation>
    </message>
    <message>
        <source>the aircraft stands %1° from %2; within 5° is wanted</source>
        <translation>statek powietrzny stoi %1° od %2; pożądane jest 5°</translation>
    </message>
    <message>
        <source>swings %1</source>
        <translation>pomiary %1</translation>
    </message>
    <message>
        <source>hard iron</source>
        <translation>żelazo twarde</translation>
    </message>
    <message>
        <source>vertical soft iron</source>
        <translation>pionowe żelazo miękkie</translation>
    </message>
    <message>
        <source>swing %1: B and C taken as all %2</source>
        <translation>pomiar %1: B i C w całości jako %2</translation>
    </message>
    <message>
        <source>; the swing states no field: H %1 nT, dip %2° as set on this page</source>
        <translation>; pomiar nie podaje pola: H %1 nT, inklinacja %2° jak ustawiono na tej stronie</translation>
    </message>
    <message>
        <source>separated, %1 places</source>
        <translation>rozdzielone, miejsc: %1</translation>
    </message>
    <message>
        <source>against attitude the Earth&apos;s field and its dip must be known: enter both</source>
        <translation>względem położenia kątowego muszą być znane pole Ziemi i jego inklinacja: podaj oba</translation>
    </message>
    <message>
        <source>registration of the aircraft</source>
        <translation>znaki rejestracyjne statku powietrznego</translation>
    </message>
    <message>
        <source>aircraft type</source>
        <translation>typ statku powietrznego</translation>
    </message>
    <message>
        <source>compass</source>
        <translation>busola</translation>
    </message>
    <message>
        <source>date</source>
        <translation>data</translation>
    </message>
    <message>
        <source>compass base</source>
        <translation>krąg dewiacyjny</translation>
    </message>
    <message>
        <source>as found or as left</source>
        <translation>stan zastany lub pozostawiony</translation>
    </message>
    <message>
        <source>kind of swing</source>
        <translation>rodzaj pomiaru</translation>
    </message>
    <message>
        <source>radio on or off</source>
        <translation>radio włączone lub wyłączone</translation>
    </message>
    <message>
        <source>who read the datum (crew)</source>
        <translation>kto odczytywał wzorzec (załoga)</translation>
    </message>
    <message>
        <source>who read the compass</source>
        <translation>kto odczytywał busolę</translation>
    </message>
    <message>
        <source>inspector</source>
        <translation>kontroler</translation>
    </message>
    <message>
        <source>adjuster</source>
        <translation>kompensujący</translation>
    </message>
    <message>
        <source>note</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <source>work order</source>
        <translation>zlecenie</translation>
    </message>
    <message>
        <source>number that tells swings of one day apart</source>
        <translation>numer odróżniający pomiary z jednego dnia</translation>
    </message>
    <message>
        <source>magnetic heading of a reading</source>
        <translation>kurs magnetyczny odczytu</translation>
    </message>
    <message>
        <source>compass heading of a reading</source>
        <translation>kurs kompasowy odczytu</translation>
    </message>
    <message>
        <source>deviation of a reading (magnetic − compass)</source>
        <translation>dewiacja odczytu (magnetyczny − kompasowy)</translation>
    </message>
    <message>
        <source>indication error of a reading (compass − magnetic)</source>
        <translation>błąd wskazania odczytu (kompasowy − magnetyczny)</translation>
    </message>
    <message>
        <source>a table of swings (CSV)</source>
        <translation>tabela pomiarów (CSV)</translation>
    </message>
    <message>
        <source>the swing was completed since; expected it to be opened again first</source>
        <translation>pomiar w międzyczasie ukończono; oczekiwano, że najpierw zostanie ponownie otwarty</translation>
    </message>
    <message>
        <source>its folder cannot be opened; expected a folder of the user&apos;s own</source>
        <translation>nie da się otworzyć jego folderu; oczekiwano własnego folderu użytkownika</translation>
    </message>
    <message>
        <source>others may write into its folder; expected a folder of the user&apos;s own</source>
        <translation>inni mogą pisać w jego folderze; oczekiwano własnego folderu użytkownika</translation>
    </message>
    <message>
        <source>this is no plain file; expected the recovery file that this program has written</source>
        <translation>to nie jest zwykły plik; oczekiwano pliku odzyskiwania zapisanego przez ten program</translation>
    </message>
    <message>
        <source>others may have written this file; expected one of the user&apos;s own</source>
        <translation>inni mogli zapisać ten plik; oczekiwano własnego pliku użytkownika</translation>
    </message>
    <message>
        <source>this file is larger than any that this program has written; expected a recovery file</source>
        <translation>ten plik jest większy niż jakikolwiek zapisany przez ten program; oczekiwano pliku odzyskiwania</translation>
    </message>
    <message>
        <source>this is a link; expected the recovery file that this program has written</source>
        <translation>to jest dowiązanie; oczekiwano pliku odzyskiwania zapisanego przez ten program</translation>
    </message>
    <message>
        <source>this file cannot be read; expected one of the user&apos;s own</source>
        <translation>tego pliku nie da się odczytać; oczekiwano własnego pliku użytkownika</translation>
    </message>
    <message>
        <source>this file cannot be written; expected one of the user&apos;s own</source>
        <translation>tego pliku nie da się zapisać; oczekiwano własnego pliku użytkownika</translation>
    </message>
    <message>
        <source>the drive takes no more; expected room for it</source>
        <translation>dysk nie przyjmuje więcej; oczekiwano na to miejsca</translation>
    </message>
    <message>
        <source>the drive failed; expected one that is there</source>
        <translation>dysk zawiódł; oczekiwano takiego, który jest podłączony</translation>
    </message>
    <message>
        <source>save the model, or store it with the compass: it takes these errors out of what the sensor measures</source>
        <translation>zapisz model albo zachowaj go przy busoli: usuwa te błędy z tego, co mierzy czujnik</translation>
    </message>
    <message>
        <source>an exchange file</source>
        <translation>plik wymiany</translation>
    </message>
</context>
</TS>
