<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl_PL" sourcelanguage="en">
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
    <message>
        <source>%1 swings</source>
        <translation>pomiary: %1</translation>
    </message>
    <message>
        <source>made %1</source>
        <translation>sporządzono %1</translation>
    </message>
</context>
<context>
    <name>app</name>
    <message>
        <source>this swing is of %1, %2; expected the aircraft and compass of %3 (%4, %5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 findings in %2 swings; expected none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the demonstration database has no swing with a result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder cannot be made; expected one that may be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window could not be started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is no day of the calendar; expected YYYY-MM-DD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--cause: &apos;%1&apos; is not known; expected one of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--cause: &apos;%1&apos; is not known; expected one of %2 (did you mean %3?)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no event &apos;%1&apos;; expected a record id as `lubberline due` tells it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; begins %2 events; expected more of the record id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an Electrical JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no aircraft type &apos;%1&apos; with a compass; expected one of the fleet, or all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no rule &apos;%1&apos;; expected one that `lubberline rule` lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--role: &apos;%1&apos; is not known; expected %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the horizontal field at the sensor vanishes on every heading, which leaves no readings for %1; expected a compass that points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the horizontal field at the sensor vanishes on heading %1: no compass heading there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--switch &quot;%1&quot;; expected NAME=on or NAME=off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no circuit &quot;%1&quot;; the model has none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no circuit &quot;%1&quot;; the model has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the data folder cannot be made; name a database with --db FILE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PostgreSQL databases are not supported yet; expected an SQLite file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing %1 is of another compass; expected swings of one compass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swing %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set, or QT_QPA_PLATFORM names one that nobody sees); commands work without one: lubberline --help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window of the demonstration fleet could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard input (-) is named twice; expected it once, it can be read only once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a database is no stream; expected the name of an SQLite file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is the swing of %1 once more; expected another swing of the same compass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this swing is %1, that of %2 %3; expected two swings with the same adjustment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two columns could not be told apart (both %1); expected one swing with the radio on and one with it off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this file is %1 once more; expected another swing of the same compass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither file names its aircraft: whether both swings are of one compass is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>no signed swing is on record</source>
        <translation>w zapisach nie ma podpisanego pomiaru dewiacji</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n month(s) after the swing of %2</source>
        <translation>
            <numerusform>%1: %n miesiąc po pomiarze z %2</numerusform>
            <numerusform>%1: %n miesiące po pomiarze z %2</numerusform>
            <numerusform>%1: %n miesięcy po pomiarze z %2</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>the line has %n figure(s); it is cut short</source>
        <translation>
            <numerusform>wiersz ma %n liczbę; jest ucięty</numerusform>
            <numerusform>wiersz ma %n liczby; jest ucięty</numerusform>
            <numerusform>wiersz ma %n liczb; jest ucięty</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>has %n word(s) where the header has %1</source>
        <translation>
            <numerusform>ma %n wyraz, a nagłówek %1</numerusform>
            <numerusform>ma %n wyrazy, a nagłówek %1</numerusform>
            <numerusform>ma %n wyrazów, a nagłówek %1</numerusform>
        </translation>
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
        <source>a date of the calendar as YYYY-MM-DD</source>
        <translation>data kalendarzowa jak RRRR-MM-DD</translation>
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
    <message numerus="yes">
        <source>the row has %n cell(s); expected %1 cells as in the header</source>
        <translation>
            <numerusform>wiersz ma %n komórkę; oczekiwano tylu komórek co w nagłówku: %1</numerusform>
            <numerusform>wiersz ma %n komórki; oczekiwano tylu komórek co w nagłówku: %1</numerusform>
            <numerusform>wiersz ma %n komórek; oczekiwano tylu komórek co w nagłówku: %1</numerusform>
        </translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{H_nT, dip_deg} or {lat_deg, lon_deg, alt_m, date}</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a grid of %1 cells a side is too coarse; expected %2 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a grid of %1 cells a side takes %2 MiB of memory; expected no more than %3 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the body is larger than its grid of %1 cells a side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the demagnetisation tensor was cancelled</source>
        <translation type="unfinished"></translation>
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
    <message numerus="yes">
        <source>%n sentence(s) with a wrong checksum left out</source>
        <translation>
            <numerusform>pominięto %n komunikat z błędną sumą kontrolną</numerusform>
            <numerusform>pominięto %n komunikaty z błędną sumą kontrolną</numerusform>
            <numerusform>pominięto %n komunikatów z błędną sumą kontrolną</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentence(s) without a checksum: what was damaged on the way cannot be told</source>
        <translation>
            <numerusform>%n komunikat bez sumy kontrolnej: nie wiadomo, co uszkodziło się po drodze</numerusform>
            <numerusform>%n komunikaty bez sumy kontrolnej: nie wiadomo, co uszkodziło się po drodze</numerusform>
            <numerusform>%n komunikatów bez sumy kontrolnej: nie wiadomo, co uszkodziło się po drodze</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>the N–S control was turned after %n reading(s) of the check swing: void, and to be read again</source>
        <translation>
            <numerusform>regulację N–S obrócono po %n odczycie pomiaru kontrolnego: traci on ważność i trzeba go powtórzyć</numerusform>
            <numerusform>regulację N–S obrócono po %n odczytach pomiaru kontrolnego: tracą one ważność i trzeba je powtórzyć</numerusform>
            <numerusform>regulację N–S obrócono po %n odczytach pomiaru kontrolnego: tracą one ważność i trzeba je powtórzyć</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the E–W control was turned after %n reading(s) of the check swing: void, and to be read again</source>
        <translation>
            <numerusform>regulację E–W obrócono po %n odczycie pomiaru kontrolnego: traci on ważność i trzeba go powtórzyć</numerusform>
            <numerusform>regulację E–W obrócono po %n odczytach pomiaru kontrolnego: tracą one ważność i trzeba je powtórzyć</numerusform>
            <numerusform>regulację E–W obrócono po %n odczytach pomiaru kontrolnego: tracą one ważność i trzeba je powtórzyć</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the index control was turned after %n reading(s) of the check swing: void, and to be read again</source>
        <translation>
            <numerusform>nastawienie obrócono po %n odczycie pomiaru kontrolnego: traci on ważność i trzeba go powtórzyć</numerusform>
            <numerusform>nastawienie obrócono po %n odczytach pomiaru kontrolnego: tracą one ważność i trzeba je powtórzyć</numerusform>
            <numerusform>nastawienie obrócono po %n odczytach pomiaru kontrolnego: tracą one ważność i trzeba je powtórzyć</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>it has %n reading(s) that count; expected at least %1</source>
        <translation>
            <numerusform>ma %n liczący się odczyt; oczekiwano co najmniej %1</numerusform>
            <numerusform>ma %n liczące się odczyty; oczekiwano co najmniej %1</numerusform>
            <numerusform>ma %n liczących się odczytów; oczekiwano co najmniej %1</numerusform>
        </translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a map of %1 x %2 has %3 points and takes %4 MiB; expected at most %5 points</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(f tan I + Q/H)/λ = C = %1</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ, the directive force: a compass shows directions, not sizes</source>
        <translation>λ, siła kierująca: busola pokazuje kierunki, nie wielkości</translation>
    </message>
    <message>
        <source>a and e each, b and d each: on a level heading only a − e, d + b and d − b act</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>g, h, k and R: they act in pitch and roll only</source>
        <translation>g, h, k i R: działają tylko przy pochyleniu i przechyleniu</translation>
    </message>
    <message>
        <source>the turn of the mount apart from (d − b)/2λ, and its tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft-iron constants and currents apart from hard iron: both are constant in body axes</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ends without its line of nines within degree %1, before order %2: it is cut short</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has one epoch and no column of the yearly change (as &quot;2025-30&quot;), so it says nothing of any other year; expected both</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 compass systems are in one selection: choose one for a pattern that an aircraft has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swings with the radio on and off are in one selection: choose one state</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) left out: %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>one aircraft is no population: no spread between aircraft can be told</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) not held against a limit: their compass has none</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>no pair of a swing as left and the next as found: how often limits are exceeded between inspections cannot be told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the compasses have different limits: an expected share is told for one limit only</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n compass(es) not ranked: no limit is known</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swing(s) not compared through the years: the other radio state</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>few swings of a kind: their scatter is estimated in each series, and only large jumps are found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a grid of %1 headings; expected 3 to 360</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no swing is in the selection; expected at least one that is complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2: %3 jumped by %4° ± %5° between %6 and %7</source>
        <translation type="unfinished"></translation>
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
        <source>its sum (CUSUM)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its average (EWMA)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: A lies %3 what is usual by %4; the average stood at %5°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fell by %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rose by %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean |A| %1, from %2° in %3 swings to %4° in %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compared at %1, as was asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the change lies between the swings of %1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the %1 compasses that were swung on both sides alone, the mean |A| changed by %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no compass was swung on both sides: the change cannot be told from one of the aircraft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what else changed at that date (crews, datum instrument, base) cannot be told from training by these figures</source>
        <translation type="unfinished"></translation>
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
    <message numerus="yes">
        <source>%n swing(s) known: mostly its type&apos;s scatter</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base: most swings name none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aircraft: each has one swing, so that it cannot be told from a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aircraft: there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base: there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crew: there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crew: each made one swing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base: each had one swing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crew: each had one aircraft, and each aircraft one crew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base: each had one aircraft, and each aircraft one base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crew and base: each base has one crew, so that what is told as the base&apos;s may be the crew&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crew: there are more of them than are told apart here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base: there are more of them than are told apart here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer than two swings: no variance can be told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all swings are equal: there is no variance to be divided</source>
        <translation type="unfinished"></translation>
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
    <message numerus="yes">
        <source>no fix: the receiver says so in all %n of its RMC and VTG (status V, mode N), so there is no track to hold the compass against</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the true heading %1 is sent by a magnetic compass: it is no reference for one</source>
        <translation>kurs rzeczywisty %1 wysyła busola magnetyczna: nie może być dla niej odniesieniem</translation>
    </message>
    <message>
        <source>holds no compass heading: all are negative or beyond 360</source>
        <translation>nie zawiera kursu kompasowego: wszystkie są ujemne lub większe niż 360</translation>
    </message>
    <message numerus="yes">
        <source>%n heading(s) that are none (negative, or beyond 360) left out</source>
        <translation>
            <numerusform>pominięto %n kurs nieistniejący (ujemny lub powyżej 360)</numerusform>
            <numerusform>pominięto %n kursy nieistniejące (ujemne lub powyżej 360)</numerusform>
            <numerusform>pominięto %n kursów nieistniejących (ujemnych lub powyżej 360)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n time(s) the receiver had no fix (status V, mode N)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) or heading(s) are estimated (mode E, dead reckoning): perhaps from the very compass that is swung</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) or heading(s) were typed in (mode M)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s) or heading(s) come from a simulator (mode S)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n HDG sentence(s) with a deviation of their own (up to %1°, east +), which is not applied: the heading beside it is the sensor&apos;s before it; an instrument that has applied it already must be swung with it cleared</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>wind from %1° true at %2 ± %3 kt, airspeed %4 kt, is taken out of the tracks</source>
        <translation>wiatr z %1° rzeczywistych, %2 ± %3 w, prędkość powietrzna %4 w, został odjęty od kątów drogi</translation>
    </message>
    <message>
        <source>the reference is %1 ± %2 s older than the heading beside it; that is taken out</source>
        <translation>odniesienie jest starsze od sąsiedniego kursu o %1 ± %2 s; uwzględniono to</translation>
    </message>
    <message>
        <source>most of the turn is faster than %1°/s: a card in its liquid lags; %2 to %1°/s tells more</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the survey of %1 has the declination %2° (east +), the model %3°: what lies in the ground there is in no model; state the variation of the survey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tracks do not tell the wind (three directions at one airspeed would): each knot of it across turns the track from the heading by %1°, into A, B and C; their errors allow for %2 kt of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log tells no time: its turn is taken as one of 1°/s</source>
        <translation>zapis nie podaje czasu: przyjęto obrót 1°/s</translation>
    </message>
    <message>
        <source>the turn goes one way at about one rate: A and a delay between heading and reference cannot be told apart, each second of delay is %1° of A; A is sure to ± %2° only (a turn the other way would tell)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the headings are too uneven to tell the delay between heading and reference: each second of it is %1° of A</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>there are readings on %n heading(s), and five coefficients need five</source>
        <translation>
            <numerusform>odczyty są na %n kursie, a pięć współczynników wymaga pięciu</numerusform>
            <numerusform>odczyty są na %n kursach, a pięć współczynników wymaga pięciu</numerusform>
            <numerusform>odczyty są na %n kursach, a pięć współczynników wymaga pięciu</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>%n reading(s) cannot be checked against each other: a misread figure would not be seen</source>
        <translation>
            <numerusform>%n odczytu nie da się sprawdzić z innymi: błędnej wartości nie byłoby widać</numerusform>
            <numerusform>%n odczytów nie da się sprawdzić ze sobą: błędnej wartości nie byłoby widać</numerusform>
            <numerusform>%n odczytów nie da się sprawdzić ze sobą: błędnej wartości nie byłoby widać</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) hold little against each other: a figure misread by less than about %1° could pass unseen</source>
        <translation>
            <numerusform>%n odczyt słabo się sprawdza: pomyłka mniejsza niż około %1° mogłaby przejść niezauważona</numerusform>
            <numerusform>%n odczyty słabo sprawdzają się nawzajem: pomyłka mniejsza niż około %1° mogłaby przejść niezauważona</numerusform>
            <numerusform>%n odczytów słabo sprawdza się nawzajem: pomyłka mniejsza niż około %1° mogłaby przejść niezauważona</numerusform>
        </translation>
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
        <source>the compass reads the reciprocal: %1°%2 was taken out as its index before B, C, D and E; look whether it was read from the other side or is mounted back to front</source>
        <translation>busola wskazuje kurs odwrotny: %1°%2 usunięto jako jej indeks przed B, C, D i E; sprawdź, czy nie odczytano jej z drugiej strony albo nie zamontowano tyłem</translation>
    </message>
    <message>
        <source>the compass is %1°%2 out as a whole: this was taken out as its index before B, C, D and E; look at its mount and its lubber line</source>
        <translation>busola jest w całości przesunięta o %1°%2: usunięto to jako jej indeks przed B, C, D i E; sprawdź mocowanie i kreskę kursową</translation>
    </message>
    <message>
        <source>vertical soft iron (c, f) of about %1, hard iron (P, Q) of about %2 nT, compensating magnets of about %3 nT and a one-cycle error of the compass itself of about %4° (standard deviations)</source>
        <translation type="unfinished"></translation>
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
        <source>OVER THE LIMIT of %1 (%2): the deviation on %3</source>
        <translation>PONAD GRANICĘ %1 (%2): dewiacja na %3</translation>
    </message>
    <message>
        <source>OVER THE LIMIT of %1 (%2): the spread of the deviation, %3</source>
        <translation>PONAD GRANICĘ %1 (%2): rozrzut dewiacji, %3</translation>
    </message>
    <message>
        <source>OVER THE LIMIT of %1 (%2): the deviation that was read on %3, %4</source>
        <translation>PONAD GRANICĘ %1 (%2): dewiacja odczytana na %3, %4</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log is dated %1, a day on which the GPS week count began: the receiver did not know the date; state it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log is dated %1, and today is %2: one of the clocks is wrong</source>
        <translation>zapis ma datę %1, a dziś jest %2: jeden z zegarów jest błędny</translation>
    </message>
    <message>
        <source>the log is dated %1: a receiver that missed the turn of the GPS week count (1024 weeks) writes so for %2; state the date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ground speed varies with the track, as if wind or current of %1 kt carried it: on wheels that is the driver; otherwise B and C are out by up to %2°; it can be taken out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no pair of readings; expected both compasses read together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reading has a datum beside it: had both compasses moved alike, their readings would agree; that is not told apart from the datum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a compass without a swing on record has no card: what it always deviated counts as if it had moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>both were read on %n heading(s) only; what changed elsewhere is not seen</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>not told which: the first has moved with %1 %, the second with %2 %, neither with %3 %; read them once beside a datum</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>even readings that agree with the card in full would leave a chance of %1 % that it does not hold: these headings are too few to clear this compass</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a quoted cell does not end in this row; expected figures and short texts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has no header; expected %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column %1 stands there twice; expected each once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the columns %1 and %2 say the same; expected one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has %1 cells; expected the %2 of the header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 is no figure; expected a number, or nothing where it is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 to 3000 knots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 to 360</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ነ to 90</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ↀ to 360</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Wind CSV: named columns, a report a row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a header but no reports; expected one a row below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no column %1; expected ground_speed_kt, track_deg, wind_speed_kt, wind_from_deg, ref_wind_speed_kt and ref_wind_from_deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no reported wind; expected wind_speed_kt and wind_from_deg, or heading_deg and tas_kt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column %1 means nothing here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no position with a time: the declination is not taken out, and the argument of the fit is the true heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time_utc %1 is no time; expected YYYY-MM-DDTHH:MM:SSZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Wind CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither Scenario JSON nor a table of manoeuvres; expected { or from_s,to_s,turn_rate_deg_s,…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stands inside a figure; expected it beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stands twice; expected it once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cell in quotes that does not end; expected names of columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column %1 stands twice; expected it once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column %1; expected from_s, to_s, turn_rate_deg_s, acceleration_m_s2 and climb_m_s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cells and %2 columns; expected a cell a column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing; expected when the manoeuvre begins and ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is %1; expected %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>says again what rms_m_s2 says; expected one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compass.model: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Scenario JSON (a flight and its heading references)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Scenario JSON or a table of manoeuvres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reference wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no wind of its own, and no heading with airspeed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rolling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climbing or descending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>airspeed too low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same report again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no report can be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the declination is not taken out of %1 of %2 reports (no position or no time): their argument is the true heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; nothing is fitted until it is said which (winds from or towards, kt or m/s, or as the file says)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the headings that were flown do not tell %1: no figure is given for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one flight only: what its reports share (an error of the reference wind) cannot be told from deviation, and nothing is held out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the headings that were flown do not tell D and E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D and E are told, and are not surely there (p = %1): the table is that of A, B and C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D and E are there (p = %1): the table is no sine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the deviation changed between the flights %1 and %2 (p = %3); the fit is of the flights since</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n report(s) came twice and count once</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>the heading error follows the declination from place to place: the winds were made with magnetic headings that were taken as true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset, %1°, is the declination, %2°, the other way: the headings may be magnetic and taken as true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heading_deg is magnetic here, and not true: it agrees with the winds once the declination is added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sine that the fleet has in common, B %1° and C %2°, is taken out: a deviation that all aircraft have goes with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fleet has B %1° and C %2° in common: a deviation of them all, or a constant error of the reference wind of %3 kt; these figures cannot tell which</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too few aircraft to bound what they have in common: a constant error of the reference wind of 1 kt looks like %1° of B or C and is not told apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds are not what their column says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as blowing towards the direction given, and not from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as m/s, and not as knots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as m/s and as blowing towards the direction given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as twice too large (knots that were converted twice)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds fit when they are taken as twice too large and as blowing towards the direction given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference winds are not what their column says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reported and reference winds blow against each other: one of them is given as blowing towards, and not from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reported winds are half of the reference winds: one of them is in m/s, and not in knots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reported and reference winds are in two units and blow against each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference winds are half of the reported winds: one of them is in m/s, and not in knots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>airspeeds are far more even when both winds are taken as blowing towards the directions given, and not from them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading</source>
        <translation type="unfinished">odczytu</translation>
    </message>
    <message>
        <source>drift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>published direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lining up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one-cycle error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-cycle error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levelling loop is unstable: third order needs tau3 &gt; tau2, and tau3 is %1 s with tau2 %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed of %1 m/s is beyond an aircraft&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the turn of %1°/s is beyond an aircraft&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an acceleration of %1 g is beyond an aircraft&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>so near to a pole every track crosses meridians at once: what goes with tan of the latitude is left out; steer by grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the aircraft is slowed below standing still; it stays at 0 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no horizontal field is left at the sensor at times: what it read before is held there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2; expected more than 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levelling time constant (tau1_s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the damping time constant (tau2_s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the integral time constant (tau3_s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levelling rate limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cut-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time constant of fast levelling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the slaving time constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the slaving rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fast slaving rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the duration is negative; expected 0 s or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s in steps of %2 s are more than 2000000 steps; expected a wider step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a manoeuvre from %1 s to %2 s ends before it begins; expected to_s after from_s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the period of the gusts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the period of the card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the compass&apos;s model stands in no horizontal field; expected its field with H above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plumb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sun is %1° below the horizon: it throws no shadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sun stands %1° high: its azimuth tells little (±%2°, one standard deviation); wait until it is lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sun stands %1° high: shadows are %2 times as long as the pin, and faint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sun&apos;s place is held against almanacs from 1950 to 2050 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no time; expected YYYY-MM-DDTHH:MM:SSZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not say which clock it is of; expected Z (UTC) or an offset as +02:00 behind it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a table of variation has steps of 0.1° to 30°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vertical gyro tumbles: it is at its stop, 90° from the vertical, from %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the apparent vertical leans by up to %1°, and the book&apos;s a/g takes it for %2°; exact_tilt takes the angle itself</source>
        <translation type="unfinished"></translation>
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
        <source>the database has the old schema %1 and may only be read; expected one that may be written once, to bring it up to date</source>
        <translation>baza ma stary schemat %1 i można ją tylko czytać; oczekiwano takiej, którą można raz zapisać, aby ją zaktualizować</translation>
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
        <source>%1 is stored where a day should be; expected YYYY-MM-DD</source>
        <translation>w miejscu daty zapisano %1; oczekiwano RRRR-MM-DD</translation>
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
        <source>the electrical swing %1 does not read: %2</source>
        <translation>pomiaru elektrycznego %1 nie da się odczytać: %2</translation>
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
        <source>the survey of the site %1 does not read: %2</source>
        <translation>pomiaru miejsca %1 nie da się odczytać: %2</translation>
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
        <source>foreign key: a row of %1 refers to a missing row of %2</source>
        <translation>klucz obcy: wiersz %1 odwołuje się do brakującego wiersza %2</translation>
    </message>
    <message>
        <source>order: two readings of the swing %1 are in one place</source>
        <translation>kolejność: dwa odczyty pomiaru %1 są w jednym miejscu</translation>
    </message>
    <message>
        <source>figure: %1 of the record %2 is not a real number</source>
        <translation>liczba: %1 zapisu %2 nie jest rzeczywista</translation>
    </message>
    <message>
        <source>sensor model: %1</source>
        <translation>model czujnika: %1</translation>
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
        <source>&amp;Compass and limits</source>
        <translation>&amp;Busola i wartości dopuszczalne</translation>
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
        <source>new part</source>
        <translation>nowa część</translation>
    </message>
    <message>
        <source>new circuit</source>
        <translation>nowy obwód</translation>
    </message>
    <message>
        <source>sensor: %1</source>
        <translation>czujnik: %1</translation>
    </message>
    <message>
        <source>(circuits) %1</source>
        <translation>(obwody) %1</translation>
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
    <name>lubberline::ui::ChartHistoryPlot</name>
    <message>
        <source>Coefficients over time</source>
        <translation>Współczynniki w czasie</translation>
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
        <source>Standard error</source>
        <translation>Błąd standardowy</translation>
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
        <translation type="unfinished"></translation>
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
        <source>%1 by %2</source>
        <translation>%1 według %2</translation>
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
        <source>least squares of δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′; ψ′ is the compass heading, A to E are angles. Residual = deviation read − deviation fitted.</source>
        <translation>najmniejsze kwadraty δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′; ψ′ to kurs kompasowy, A do E to kąty. Reszta = dewiacja odczytana − dewiacja dopasowana.</translation>
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
        <source>%1° on %2</source>
        <translation>%1° na %2</translation>
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
        <source>The same, polar; amplitudes by order as found and as left</source>
        <translation>To samo biegunowo; amplitudy według rzędów, stan zastany i końcowy</translation>
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
        <source>Amplitudes by order</source>
        <translation>Amplitudy według rzędów</translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread as found: standard deviation of what was read. Between aircraft: the same with the fits&apos; own error taken out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exceedance is told from pairs: a compass as left, and the same compass as found next. The interval is exact (Clopper and Pearson).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected share: chance that the largest deviation over all headings of the next swing is beyond the limit, by Student&apos;s prediction from those that were found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three-sigma share: mean and standard deviation of the worst single heading taken as if they were known, as in the source paper; too small for few swings and for many headings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variance components by restricted maximum likelihood; intervals by profile of the likelihood at 95 %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A jump&apos;s date is the interval between two swings. One in ten of the jumps that are told may be false.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who next: chance of being out of limits at some time up to the date, by level, drift and wander of each coefficient since the last swing, shrunk to its type.</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three sigma</source>
        <translation>trzy sigma</translation>
    </message>
    <message>
        <source>the paper&apos;s</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean |A|</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jumps, at a false discovery rate of 10 %</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>event, likely part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drifts, at a false discovery rate of 10 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a year</source>
        <translation>rocznie</translation>
    </message>
    <message>
        <source>Who next: out of limits before the next date</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <source>Aircraft</source>
        <translation>Statek powietrzny</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Kompasowy</translation>
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
        <source>What calls for a swing, and since when: by the calendar rules, by an event such as a lightning strike, or by a move. Enter opens the compass. An event that needs no swing is waived, with a reason and a name that stay on the record.</source>
        <translation>Co wymaga pomiaru i od kiedy: reguła kalendarzowa, zdarzenie, np. uderzenie pioruna, albo przebazowanie. Enter otwiera busolę. Od zdarzenia, które nie wymaga pomiaru, odstępuje się z powodem i nazwiskiem, które pozostają w zapisie.</translation>
    </message>
    <message>
        <source>Write the &amp;calendar (.ics)…</source>
        <translation>Zapisz &amp;kalendarz (.ics)…</translation>
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
        <translation>Pole Pole &amp;ziemskieZiemi</translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <source>“%1” is no date; expected year-month-day, as 2026-11-20</source>
        <translation>„%1” nie jest datą; oczekiwano rok-miesiąc-dzień, na przykład 2026-11-20</translation>
    </message>
    <message>
        <source>“%1” is no size of a division; expected degrees above 0 and up to 90, as 0.5</source>
        <translation>„%1” nie jest wielkością działki; oczekiwano stopni powyżej 0, najwyżej 90, na przykład 0.5</translation>
    </message>
    <message>
        <source>“%1” is no year; expected four digits, as 1984</source>
        <translation>„%1” nie jest rokiem; oczekiwano czterech cyfr, na przykład 1984</translation>
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
        <source>this swing is not a guided one</source>
        <translation>ten pomiar nie jest prowadzony</translation>
    </message>
    <message>
        <source>Fault: %1. What was done about it?</source>
        <translation>Usterka: %1. Co z nią zrobiono?</translation>
    </message>
    <message>
        <source>This swing was abandoned.</source>
        <translation>Ten pomiar przerwano.</translation>
    </message>
    <message>
        <source>What is the fault? F8 goes back.</source>
        <translation>Jaka to usterka? F8 wraca.</translation>
    </message>
    <message>
        <source>Why is the swing abandoned? Some words are expected; its readings stay on record.</source>
        <translation>Dlaczego pomiar jest przerwany? Oczekiwano kilku słów; odczyty pozostają w zapisie.</translation>
    </message>
    <message>
        <source>The datum of this swing is sighted by a person: a live heading is none of its figures. Begin the swing with an instrument that sends headings.</source>
        <translation>Wzorzec tego pomiaru odczytuje człowiek: kurs na żywo nie jest jego odczytem. Zacznij pomiar z przyrządem, który wysyła kursy.</translation>
    </message>
    <message>
        <source>The live heading is true and the datum magnetic, or the other way round: a variation is expected, of the site or in the sentences.</source>
        <translation>Kurs na żywo jest rzeczywisty, a wzorzec magnetyczny, albo odwrotnie: oczekiwano deklinacji miejsca lub podanej w komunikatach.</translation>
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
        <source>One step a page: turn to the heading, type what datum and compass read, Enter. F2 repeats a step, F4 leaves it out, F8 reports a fault, F11 shows the crew&apos;s display, F12 listens to instruments. Every figure is stored as it is typed; an interrupted swing goes on where it stood.</source>
        <translation>Jeden krok na stronie: ustaw kurs, wpisz odczyt wzorca i busoli, Enter. F2 powtarza krok, F4 go pomija, F8 zgłasza usterkę, F11 pokazuje ekran załogi, F12 nasłuchuje przyrządów. Każda liczba jest zapisywana od razu; przerwany pomiar podejmuje się tam, gdzie stanął.</translation>
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
        <source>Read this one again</source>
        <translation>Odczytaj ten ponownie</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>SE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>SW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>NW</source>
        <translation type="unfinished"></translation>
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
        <source>New instrument</source>
        <translation>Nowy przyrząd</translation>
    </message>
    <message>
        <source>New instrument %1</source>
        <translation>Nowy przyrząd %1</translation>
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
    <name>lubberline::ui::LiveInput</name>
    <message>
        <source>closed</source>
        <translation>zamknięte</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>nie można otworzyć %1: %2</translation>
    </message>
    <message>
        <source>the serial port has vanished</source>
        <translation>port szeregowy zniknął</translation>
    </message>
    <message>
        <source>listening on %1 at %2 baud</source>
        <translation>nasłuch na %1, %2 bodów</translation>
    </message>
    <message>
        <source>UDP port %1 cannot be used: %2</source>
        <translation>nie można użyć portu UDP %1: %2</translation>
    </message>
    <message>
        <source>listening on UDP port %1</source>
        <translation>nasłuch na porcie UDP %1</translation>
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
        <translation>%1; ponawianie</translation>
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
        <source>A serial port with its baud rate, as /dev/ttyUSB0 4800; a UDP port, as 10110; or the path of a log</source>
        <translation>Port szeregowy z prędkością, np. /dev/ttyUSB0 4800; port UDP, np. 10110; albo ścieżka zapisu</translation>
    </message>
    <message>
        <source>Where does it come from? A port or the path of a log is expected.</source>
        <translation>Skąd mają płynąć dane? Oczekiwano portu albo ścieżki zapisu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no UDP port; expected a number from 1 to 65535</source>
        <translation>„%1” nie jest portem UDP; oczekiwano liczby od 1 do 65535</translation>
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
        <source>%1° %2</source>
        <translation>%1° %2</translation>
    </message>
    <message>
        <source>✓</source>
        <translation>✓</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source> true</source>
        <translation> rzeczywisty</translation>
    </message>
    <message>
        <source>Nothing is heard: a heading is expected.</source>
        <translation>Nic nie słychać: oczekiwano kursu.</translation>
    </message>
    <message>
        <source>The heading has not settled yet: it moves by %1° within the window.</source>
        <translation>Kurs jeszcze się nie ustalił: zmienia się o %1° w oknie pomiaru.</translation>
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
</context>
<context>
    <name>lubberline::ui::MainWindow</name>
    <message>
        <source>%1 – Lubberline</source>
        <translation type="unfinished"></translation>
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
        <source>&amp;Search everything</source>
        <translation>&amp;Szukaj wszędzie</translation>
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
        <source>&amp;Back up the database…</source>
        <translation>Kopia zapasowa &amp;bazy danych…</translation>
    </message>
    <message>
        <source>&amp;About Lubberline</source>
        <translation>&amp;O programie Lubberline</translation>
    </message>
    <message>
        <source>Lubberline %1: aircraft magnetic deviation. Based in part on the work of the Qwt project (http://qwt.sf.net).</source>
        <translation>Lubberline %1: dewiacja magnetyczna statków powietrznych. Oparte częściowo na pracy projektu Qwt (http://qwt.sf.net).</translation>
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
        <source>Back up the database</source>
        <translation>Kopia zapasowa bazy danych</translation>
    </message>
    <message>
        <source>Lubberline databases (*.lubberline)</source>
        <translation>Bazy danych Lubberline (*.lubberline)</translation>
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
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
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
        <source>&amp;Help on this page</source>
        <translation>&amp;Pomoc do tej strony</translation>
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
</context>
<context>
    <name>lubberline::ui::MessagePanel</name>
    <message>
        <source>Dismiss</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Dismiss this message</source>
        <translation>Zamknij ten komunikat</translation>
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
</context>
<context>
    <name>lubberline::ui::OverviewPage</name>
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
        <source>The fleet and the state of its aircraft: that of the newest swing of each compass, held against its limits. Click an aircraft to open it; Ctrl+F finds one by name.</source>
        <translation>Flota i stan jej statków powietrznych: wynik najnowszego pomiaru każdej busoli wobec jej wartości dopuszczalnych. Kliknij statek powietrzny, aby go otworzyć; Ctrl+F znajduje po nazwie.</translation>
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
        <source>&amp;Play</source>
        <translation>Od&amp;twórz</translation>
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
        <source>found and left</source>
        <translation>zastany i końcowy</translation>
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
        <source>one aircraft, one vote</source>
        <translation>jeden statek powietrzny, jeden głos</translation>
    </message>
    <message>
        <source>one swing, one vote</source>
        <translation>jeden pomiar, jeden głos</translation>
    </message>
    <message>
        <source> headings</source>
        <translation> kursów</translation>
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
        <source>%1°: mean %2°, between aircraft ± %3°, %4 votes</source>
        <translation>%1°: średnia %2°, między statkami powietrznymi ± %3°, głosów: %4</translation>
    </message>
    <message>
        <source>The swings one after the other</source>
        <translation>Pomiary jeden po drugim</translation>
    </message>
    <message>
        <source>all types</source>
        <translation>wszystkie typy</translation>
    </message>
    <message>
        <source>all bases</source>
        <translation>wszystkie bazy</translation>
    </message>
    <message>
        <source>all compass systems</source>
        <translation>wszystkie systemy busoli</translation>
    </message>
    <message>
        <source>The fleet has changed since: compute again.</source>
        <translation>Flota zmieniła się od tego czasu: oblicz ponownie.</translation>
    </message>
    <message>
        <source>A first look at a part of the swings…</source>
        <translation>Pierwsze spojrzenie na część pomiarów…</translation>
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
        <source>%1 swings of %2 aircraft.</source>
        <translation>Pomiary: %1, statki powietrzne: %2.</translation>
    </message>
    <message>
        <source>A first look at %1 swings; all are being computed. </source>
        <translation>Pierwsze spojrzenie na pomiary (%1); wszystkie są obliczane. </translation>
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
        <source>%1 drifts by %2° a year (95 %: %3 to %4).</source>
        <translation>%1 dryfuje o %2° rocznie (95 %: %3 do %4).</translation>
    </message>
    <message>
        <source>Its limit is reached by %1 in half of the futures, by %2 in one of twenty.</source>
        <translation>Granicę osiągnie do %1 w połowie przypadków, do %2 w jednym na dwadzieścia.</translation>
    </message>
    <message>
        <source>No jump and no drift of it is told.</source>
        <translation>Nie stwierdzono jej skoku ani dryfu.</translation>
    </message>
    <message>
        <source>Filled: as found; open or dashed: as left. Bars: 95 % by the readings.</source>
        <translation>Wypełnione: stan zastany; puste lub przerywane: końcowy. Słupki: 95 % z odczytów.</translation>
    </message>
    <message>
        <source>%1 swings at %2°, those farthest from the mean first; Enter opens one.</source>
        <translation>Pomiary na %2°: %1, najpierw najdalsze od średniej; Enter otwiera.</translation>
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
        <source>wrote %1</source>
        <translation>zapisano %1</translation>
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
        <source>all swings of this compass at different places</source>
        <translation>wszystkie pomiary tej busoli w różnych miejscach</translation>
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
</context>
<context>
    <name>lubberline::ui::PredictionPlot</name>
    <message>
        <source>Prediction</source>
        <translation>Prognoza</translation>
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
        <source>incomplete</source>
        <translation>niepełny</translation>
    </message>
    <message>
        <source>suspect, %1</source>
        <translation>wątpliwy, %1</translation>
    </message>
    <message>
        <source>Not stored: %1</source>
        <translation>Nie zapisano: %1</translation>
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
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Wklej</translation>
    </message>
    <message>
        <source>Nothing was pasted: %1</source>
        <translation>Niczego nie wklejono: %1</translation>
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
        <source>model</source>
        <translation>model</translation>
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
        <source>model</source>
        <translation>model</translation>
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
        <source>circuit %1</source>
        <translation>obwód %1</translation>
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
        <source>detail</source>
        <translation>szczegóły</translation>
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
        <source>New base</source>
        <translation>Nowa baza</translation>
    </message>
    <message>
        <source>New base %1</source>
        <translation>Nowa baza %1</translation>
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
        <source>on %1 the compass reads %2; %3 ± %4° is expected.</source>
        <translation>na kursie %1 busola wskazuje %2; oczekiwano %3 ± %4°.</translation>
    </message>
    <message>
        <source>Look again: no usual slip explains it</source>
        <translation>Sprawdź ponownie: nie tłumaczy tego żadna zwykła pomyłka</translation>
    </message>
    <message>
        <source>on %1 the compass reads %2.</source>
        <translation>na kursie %1 busola wskazuje %2.</translation>
    </message>
    <message>
        <source>one of the readings on %1 was probably misread (%2); these readings cannot tell which: look at them again</source>
        <translation>jeden z odczytów na kursach %1 jest prawdopodobnie błędny (%2); te odczyty nie mówią, który: sprawdź je ponownie</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
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
        <source>This swing is complete. To change a reading, set it back to draft.</source>
        <translation>Ten pomiar jest zakończony. Aby zmienić odczyt, przywróć go do szkicu.</translation>
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
        <translation type="unfinished"></translation>
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
        <source>Not stored: %1</source>
        <translation>Nie zapisano: %1</translation>
    </message>
    <message>
        <source>Type the magnetic heading, Enter, the compass reading, Enter: the next row follows. Angles as 3.25, 3.25W, 3°15&apos;W, 3 15 W; decimal point or comma.
In the deviation column, W and E (or a sign) give the compass heading. = or Ctrl+D takes the nominal heading as read. Delete empties a cell.
Cells and blocks are copied, cut and pasted as in a spreadsheet (Ctrl+C, X, V), with or without a first row of headings.
Ctrl+Z undoes everything, across swings. Ctrl+E leaves a reading out, with a reason that stays on the record.</source>
        <translation>Wpisz kurs magnetyczny, Enter, odczyt busoli, Enter: następuje kolejny wiersz. Kąty jako 3.25, 3.25W, 3°15&apos;W, 3 15 W; kropka lub przecinek dziesiętny.
W kolumnie dewiacji W i E (albo znak) dają kurs kompasowy. = lub Ctrl+D przyjmuje kurs nominalny jako odczytany. Delete opróżnia komórkę.
Komórki i bloki kopiuje się, wycina i wkleja jak w arkuszu (Ctrl+C, X, V), z pierwszym wierszem nagłówków lub bez.
Ctrl+Z cofa wszystko, we wszystkich pomiarach. Ctrl+E pomija odczyt, z powodem, który pozostaje w zapisie.</translation>
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
        <source>3.5E</source>
        <translation>3.5E</translation>
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
        <source>Largest deviation %1 at %2. </source>
        <translation>Największa dewiacja %1 na kursie %2. </translation>
    </message>
    <message>
        <source> Not read: %1 (compass).</source>
        <translation> Nie odczytano: %1 (busola).</translation>
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
        <source>cannot be read: %1; expected an exchange file</source>
        <translation>nie daje się odczytać: %1; oczekiwano pliku wymiany</translation>
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
</context>
</TS>
