// SPDX-License-Identifier: BSD-3-Clause
// Tests tables of directions: the light that a twin then sends, the polynomials that complete them,
// and the line for each mistake.
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/io/documents.h"
#include "tests/io/twin_files.h"

using namespace hogelscope;

namespace {

/// A direction of a table: its indices, its slopes, and its light.
struct Beam {
  int u = 0;
  int v = 0;
  std::vector<double> values;
};

QByteArray csv(const QByteArray& header, const std::vector<Beam>& beams) {
  QByteArray text = header + "\n";
  for (const auto& [u, v, values] : beams) {
    text += QByteArray::number(u) + "," + QByteArray::number(v);
    for (const double value : values) text += "," + QByteArray::number(value, 'g', 17);
    text += "\n";
  }
  return text;
}

/// Slopes like those of a real lens: near the design's, distorted and turned; and some light.
Beam beamAt(int u, int v, const PanelParams& design) {
  const double s = (u + 0.5) / design.directions[0] - 0.5;
  const double t = 0.5 - (v + 0.5) / design.directions[1];
  const double x = 0.93 * s + 0.02 * t + 0.01 - 0.4 * s * s * s + 0.03 * std::sin(9 * t);
  const double y = 0.72 * t - 0.03 * s + 0.2 * s * s * t + 0.02 * std::cos(7 * s);
  return {u, v, {x, y, 4 + s, 3 - t * t, 2 + s * t}};
}

std::vector<Beam> beamsOf(const PanelParams& design, const std::function<bool(int, int)>& has) {
  std::vector<Beam> beams;
  for (int v = 0; v < design.directions[1]; ++v)
    for (int u = 0; u < design.directions[0]; ++u)
      if (has(u, v)) beams.push_back(beamAt(u, v, design));
  return beams;
}

bool always(int, int) {
  return true;
}

bool chessBoard(int u, int v) {
  return (u + v) % 2 == 0;
}

/// The polynomial of a degree that fits a value of the beams best, by the normal equations of the
/// powers of the bare indices.
class BruteForceFit {
 public:
  BruteForceFit(const std::vector<Beam>& beams, std::size_t value, int degree) : m_degree(degree) {
    const std::size_t count = powers(0, 0).size();
    std::vector<std::vector<long double>> rows(count, std::vector<long double>(count + 1));
    for (const Beam& beam : beams) {
      const std::vector<long double> own = powers(beam.u, beam.v);
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t l = 0; l < count; ++l) rows[k][l] += own[k] * own[l];
        rows[k][count] += own[k] * static_cast<long double>(beam.values[value]);
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t l = k + 1; l < count; ++l)
        if (std::abs(rows[l][k]) > std::abs(rows[k][k])) std::swap(rows[k], rows[l]);
      for (std::size_t l = 0; l < count; ++l) {
        if (l == k) continue;
        const long double factor = rows[l][k] / rows[k][k];
        for (std::size_t m = 0; m <= count; ++m) rows[l][m] -= factor * rows[k][m];
      }
    }
    for (std::size_t k = 0; k < count; ++k) m_factors.push_back(rows[k][count] / rows[k][k]);
  }

  double at(int u, int v) const {
    const std::vector<long double> own = powers(u, v);
    long double sum = 0;
    for (std::size_t k = 0; k < own.size(); ++k) sum += own[k] * m_factors[k];
    return double(sum);
  }

 private:
  std::vector<long double> powers(int u, int v) const {
    std::vector<long double> all;
    for (int a = 0; a <= m_degree; ++a)
      for (int b = 0; a + b <= m_degree; ++b)
        all.push_back(std::pow(static_cast<long double>(u), a) *
                      std::pow(static_cast<long double>(v), b));
    return all;
  }

  int m_degree;
  std::vector<long double> m_factors;
};

/// The root of the mean squared distance of the beams' slopes from polynomials.
double slopeError(const std::vector<Beam>& beams, const BruteForceFit& x, const BruteForceFit& y) {
  double sum = 0;
  for (const Beam& beam : beams)
    sum += std::pow(x.at(beam.u, beam.v) - beam.values[0], 2) +
           std::pow(y.at(beam.u, beam.v) - beam.values[1], 2);
  return std::sqrt(sum / double(beams.size()));
}

/// Compares the slopes of a twin's rays with those of polynomials where beams are missing, and with
/// the beams' own elsewhere. The planes are float: 3·10⁻⁷ of a pixel's index.
void compareRays(const TwinMaps& maps, const PanelParams& design, const std::vector<Beam>& beams,
                 const std::array<BruteForceFit, 2>& fits) {
  const Twin twin({}, maps, design);
  std::map<std::pair<int, int>, const Beam*> given;
  for (const Beam& beam : beams) given[{beam.u, beam.v}] = &beam;
  for (int v = 0; v < design.directions[1]; ++v)
    for (int u = 0; u < design.directions[0]; ++u) {
      const PanelRay ray = twin.rayOf(1, 2, u + 0.5, v + 0.5, greenChannel);
      const auto own = given.find({u, v});
      const bool isGiven = own != given.end();
      const double x = isGiven ? own->second->values[0] : fits[0].at(u, v);
      const double y = isGiven ? own->second->values[1] : fits[1].at(u, v);
      QVERIFY2(std::abs(ray.slopes.x - x) < 2e-7 && std::abs(ray.slopes.y - y) < 2e-7,
               qPrintable(QString("(%1, %2): %3 %4").arg(u).arg(v).arg(ray.slopes.x).arg(x)));
    }
}

/// A lens whose directions are the slopes, and which has none beyond 0.6.
class NarrowLens : public plugin::HogelLens {
 public:
  void describe(ParameterVisitor& v) override { v.group("narrow", "A lens of a test."); }
  void open(std::int32_t, double, const plugin::Place&) override {}
  [[nodiscard]] double directionOf(double slope) const override {
    return std::abs(slope) > 0.6 ? std::nan("") : slope;
  }
  [[nodiscard]] double slopeOf(double direction) const override { return direction; }
};

}  // namespace

class TestMeasuredDirections : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void wholeTable_data();
  void wholeTable();
  void lightOfTables();
  void columnsInAnyOrder();
  void fitted_data();
  void fitted();
  void narrowFields();
  void darkFits();
  void badTables_data();
  void badTables();
  void beyondTheLens();
  void leia();

 private:
  QTemporaryDir m_folder;
};

void TestMeasuredDirections::wholeTable_data() {
  QTest::addColumn<int>("lens");
  QTest::newRow("rectilinear") << int(HogelLensModel::rectilinear);
  QTest::newRow("equiangular") << int(HogelLensModel::equiangular);
}

/// Every pixel of the twin sends light as the table says.
void TestMeasuredDirections::wholeTable() {
  QFETCH(int, lens);
  PanelParams design = designOf({4, 3}, {9, 6});
  design.lens = HogelLensModel(lens);
  const std::vector<Beam> beams = beamsOf(design, always);
  writeFile("directions.csv", csv("u,v,x,y,r,g,b", beams));
  std::vector<std::string> warnings;
  const TwinMaps maps = read("directions.csv", design, &warnings);
  QCOMPARE(filled(maps), std::string("000000001101110"));
  QVERIFY(warnings.empty());
  QCOMPARE(maps.moveU.width, 9);
  QCOMPARE(maps.moveV.height, 6);
  const BruteForceFit unused(beams, 0, 1);
  compareRays(maps, design, beams, {unused, unused});
  for (std::size_t c = 0; c < 3; ++c) {
    double largest = 0;
    for (const Beam& beam : beams) largest = std::max(largest, beam.values[2 + c]);
    for (const auto& [u, v, values] : beams)
      QCOMPARE(maps.directionGain[c].values[std::size_t(9 * v + u)],
               float(values[2 + c] / largest));
  }
}

void TestMeasuredDirections::lightOfTables() {
  const PanelParams design = designOf({4, 3}, {2, 1});
  writeFile("directions.csv", "u,v,x,y,intensity\n0,0,-0.2,0,3\n1,0,0.2,0,12\n");
  const TwinMaps maps = read("directions.csv", design);
  for (const TwinPlane& gain : maps.directionGain) QVERIFY(isPlane(gain, 2, 1, {0.25F, 1}));
  writeFile("directions.csv", "u,v,x,y\n0,0,-0.2,0\n1,0,0.2,0\n");
  QCOMPARE(filled(read("directions.csv", design)), std::string("000000001100000"));
}

/// As spreadsheets write it, too; the extension in capitals.
void TestMeasuredDirections::columnsInAnyOrder() {
  const PanelParams design = designOf({4, 3}, {2, 1});
  writeFile("directions.CSV", "u,v,x,y,r,g,b\n0,0,-0.25,0.5,1,2,3\n1,0,0.125,-0.5,2,1,1\n");
  const TwinMaps maps = read("directions.CSV", design);
  writeFile("directions_other.csv",
            "\xEF\xBB\xBF\"y\", g,x,u ,b,v,r\r\n\r\n-0.5,1,0.125,1,1,0,2\r\n"
            " 0.5,2,-0.25,0.0,\"3\",0,1\r\n\t\r\n");
  const TwinMaps other = read("directions_other.csv", design);
  for (std::size_t k = 0; k < 15; ++k)
    QCOMPARE(allPlanes(other)[k]->values, allPlanes(maps)[k]->values);
}

void TestMeasuredDirections::fitted_data() {
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::addColumn<QList<int>>("lacks");  ///< v · columns + u; {-1}: a chess board
  QTest::addColumn<int>("degree");
  const auto but = [](int count, const QList<int>& given) {
    QList<int> lacks;
    for (int k = 0; k < count; ++k)
      if (!given.contains(k)) lacks.append(k);
    return lacks;
  };
  QTest::newRow("chess board") << 8 << 8 << QList<int>{-1} << 3;
  QTest::newRow("a gap") << 9 << 5 << QList<int>{22} << 3;
  QTest::newRow("ten") << 5 << 5 << but(25, {0, 2, 4, 7, 10, 13, 16, 19, 21, 22}) << 3;
  QTest::newRow("nine") << 5 << 5 << but(25, {0, 2, 4, 7, 10, 13, 16, 19, 21}) << 2;
  QTest::newRow("six") << 4 << 4 << but(16, {0, 2, 5, 9, 11, 15}) << 2;
  QTest::newRow("five") << 4 << 4 << but(16, {0, 2, 5, 9, 11}) << 1;
  QTest::newRow("three") << 4 << 4 << but(16, {1, 7, 12}) << 1;
  QTest::newRow("two rows of five") << 5 << 5 << but(25, {5, 6, 7, 8, 9, 15, 16, 17, 18, 19}) << 1;
  QTest::newRow("a corner") << 200 << 150
                            << but(30000, {0, 1, 2, 3, 200, 201, 202, 203, 400, 401, 402, 600})
                            << 2;
}

/// What the table has stays as it is; the rest is the polynomial of the highest degree that it
/// determines.
void TestMeasuredDirections::fitted() {
  QFETCH(int, columns);
  QFETCH(int, rows);
  QFETCH(QList<int>, lacks);
  QFETCH(int, degree);
  const PanelParams design = designOf({4, 3}, {columns, rows});
  const bool isChessBoard = lacks == QList<int>{-1};
  const std::set<int> missing(lacks.begin(), lacks.end());
  const std::vector<Beam> beams = beamsOf(design, [&](int u, int v) {
    return isChessBoard ? chessBoard(u, v) : !missing.contains(v * columns + u);
  });
  writeFile("directions.csv", csv("u,v,x,y,r,g,b", beams));
  std::vector<std::string> warnings;
  const TwinMaps maps = read("directions.csv", design, &warnings);

  const std::array fits{BruteForceFit(beams, 0, degree), BruteForceFit(beams, 1, degree)};
  compareRays(maps, design, beams, fits);
  for (std::size_t c = 0; c < 3; ++c) {
    const BruteForceFit light(beams, 2 + c, degree);
    double largest = 0;
    for (const Beam& beam : beams) largest = std::max(largest, beam.values[2 + c]);
    for (int v = 0; v < rows; ++v)
      for (int u = 0; u < columns; ++u) {
        if (isChessBoard ? chessBoard(u, v) : !missing.contains(v * columns + u)) continue;
        const double expected = std::max(0.0, light.at(u, v) / largest);
        const float found = maps.directionGain[c].values[std::size_t(v * columns + u)];
        QVERIFY(std::abs(double(found) - expected) < 1e-6 * std::max(1.0, expected));
      }
  }

  QCOMPARE(warnings.size(), std::size_t(1));
  const QString line = QString::fromStdString(warnings[0]);
  const QString kind = degree == 3 ? "cubic" : degree == 2 ? "quadratic" : "linear";
  const QString begin = QString(
                            "directions.csv: has %1 of %2 directions; the other %3 come from a "
                            "%4 polynomial, from which the slopes of the given ones are ")
                            .arg(beams.size())
                            .arg(columns * rows)
                            .arg(std::size_t(columns * rows) - beams.size())
                            .arg(kind);
  QCOMPARE(line.left(begin.size()), begin);
  QVERIFY(line.endsWith(" away (rms)"));
  const double error = line.mid(begin.size()).section(' ', 0, 0).toDouble();
  const double expected = slopeError(beams, fits[0], fits[1]);
  QVERIFY2(std::abs(error - expected) <= 1e-3 * expected + 1e-12, qPrintable(line));
}

/// One row of directions: powers of v are left out. Two columns: those of u from the square on.
void TestMeasuredDirections::narrowFields() {
  const PanelParams row = designOf({4, 3}, {9, 1});
  const auto cube = [](int u) { return 0.001 * (u - 4) * (u - 4) * (u - 4) + 0.05 * u - 0.2; };
  QByteArray text = "u,v,x,y\n";
  for (const int u : {0, 2, 5, 8})
    text += QByteArray::number(u) + ",0," + QByteArray::number(cube(u), 'g', 17) + ",0.01\n";
  writeFile("directions.csv", text);
  const Twin twin({}, read("directions.csv", row), row);
  for (int u = 0; u < 9; ++u) {
    const PanelRay ray = twin.rayOf(0, 0, u + 0.5, 0.5, greenChannel);
    QVERIFY(std::abs(ray.slopes.x - cube(u)) < 2e-7);
    QVERIFY(std::abs(ray.slopes.y - 0.01) < 2e-7);
  }
  const PanelParams columns = designOf({4, 3}, {2, 4});
  const auto bent = [](int u, int v) { return 0.1 * u + (0.02 + 0.01 * u) * v * v - 0.1; };
  text = "u,v,x,y\n";
  for (const auto& [u, v] :
       std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}, {0, 3}})
    text += QByteArray::number(u) + "," + QByteArray::number(v) + "," +
            QByteArray::number(bent(u, v), 'g', 17) + "," + QByteArray::number(-0.1 * v) + "\n";
  writeFile("directions.csv", text);
  const TwinMaps maps = read("directions.csv", columns);
  const PanelRay ray = Twin({}, maps, columns).rayOf(0, 0, 1.5, 3.5, greenChannel);
  QVERIFY(std::abs(ray.slopes.x - bent(1, 3)) < 2e-7);
  QVERIFY(std::abs(ray.slopes.y + 0.3) < 2e-7);
}

/// Light that the fit makes negative is none.
void TestMeasuredDirections::darkFits() {
  const PanelParams design = designOf({4, 3}, {4, 4});
  writeFile("directions.csv",
            "u,v,x,y,intensity\n0,0,-0.2,0.2,1\n1,0,-0.1,0.2,0\n0,1,-0.2,0.1,1\n");
  const TwinMaps maps = read("directions.csv", design);
  for (const TwinPlane& gain : maps.directionGain)
    for (std::size_t k = 0; k < 16; ++k)
      QVERIFY(std::abs(gain.values[k] - (k % 4 == 0 ? 1.0F : 0.0F)) < 1e-6F && gain.values[k] >= 0);
}

void TestMeasuredDirections::badTables_data() {
  QTest::addColumn<QByteArray>("table");
  QTest::addColumn<QByteArray>("line");
  const QByteArray start = "u,v,x,y,r,g,b\n0,0,-0.2,0.2,1,1,1\n";
  const auto after = [&](const char* row, const QByteArray& cells, const QByteArray& problem) {
    QTest::newRow(row) << start + cells + "\n"
                       << "directions.csv: line 3: " + problem;
  };
  after("no value", "1,0,,0.2,1,1,1", "x is empty");
  after("spaces", "1,0,0.1, ,1,1,1", "y is empty");
  after("no index", ",0,0.1,0.2,1,1,1", "u is empty");
  after("no light", "1,0,0.1,0.2,1,1,", "b is empty");
  after("a word", "1,0,wide,0.2,1,1,1", "x \"wide\" is not a number from -1000 to 1000");
  after("a unit", "1,0,0.1,0.2m,1,1,1", "y \"0.2m\" is not a number from -1000 to 1000");
  after("a long word", "1,0," + QByteArray(300, 'w') + ",0.2,1,1,1",
        "x \"" + QByteArray(40, 'w') + "…\" is not a number from -1000 to 1000");
  after("a control", "1,0,\x1b[1m,0.2,1,1,1", "x \"\\x1b[1m\" is not a number from -1000 to 1000");
  after("not a number", "1,0,nan,0.2,1,1,1", "x \"nan\" is not a number from -1000 to 1000");
  after("infinite", "1,0,0.1,-inf,1,1,1", "y \"-inf\" is not a number from -1000 to 1000");
  after("degrees", "1,0,0.1,1001,1,1,1", "y \"1001\" is not a number from -1000 to 1000");
  after("negative light", "1,0,0.1,0.2,1,-1,1", "g \"-1\" is not a number from 0 to 1e+12");
  after("endless light", "1,0,0.1,0.2,inf,1,1", "r \"inf\" is not a number from 0 to 1e+12");
  after("beyond the columns", "8,0,0.1,0.2,1,1,1", "u \"8\" is not a whole number from 0 to 7");
  after("beyond the rows", "0,9,0.1,0.2,1,1,1", "v \"9\" is not a whole number from 0 to 7");
  after("before the first", "-1,0,0.1,0.2,1,1,1", "u \"-1\" is not a whole number from 0 to 7");
  after("between", "0.5,0,0.1,0.2,1,1,1", "u \"0.5\" is not a whole number from 0 to 7");
  after("an index that is none", "nan,0,0.1,0.2,1,1,1",
        "u \"nan\" is not a whole number from 0 to 7");
  after("a word for an index", "1,top,0.1,0.2,1,1,1",
        "v \"top\" is not a whole number from 0 to 7");
  after("too few cells", "1,0,0.1,0.2,1,1", "has 6 cells for 7 columns");
  after("too many cells", "1,0,0.1,0.2,1,1,1,1", "has 8 cells for 7 columns");
  after("twice", "0,0,0.1,0.2,1,1,1", "has direction (0, 0), which line 2 has too");
  after("long", QByteArray(5000, ','), "is longer than 4096 bytes");
  QTest::newRow("lines are counted, empty ones too")
      << start + "\n\r\n1,0,a,0,1,1,1\n"
      << QByteArray("directions.csv: line 5: x \"a\" is not a number from -1000 to 1000");

  const auto header = [](const char* row, const QByteArray& names, const QByteArray& problem) {
    QTest::newRow(row) << names + "\n0,0,0,0\n"
                       << "directions.csv: line 1: " + problem;
  };
  const QByteArray known = " is not one of u, v, x, y, r, g, b, intensity";
  header("unknown column", "u,v,x,y,z", "column \"z\"" + known);
  header("semicolons", "u;v;x;y", "column \"u;v;x;y\"" + known);
  header("no names", "0,0,0.1,0.2", "column \"0\"" + known);
  header("an empty name", "u,v,x,y,", "column \"\"" + known);
  header("a name twice", "u,v,x,y,x", "has column \"x\" twice");
  header("no y", "u,v,x", "has to name the columns u, v, x and y");
  header("light alone", "r,g,b,intensity", "has to name the columns u, v, x and y");
  const QByteArray light = "has to name all of r, g and b, or intensity alone, or none of them";
  header("red alone", "u,v,x,y,r", light);
  header("no green", "u,v,x,y,r,b", light);
  header("blue and intensity", "u,v,x,y,b,intensity", light);
  header("all of them", "u,v,x,y,r,g,b,intensity", light);

  const auto whole = [](const char* row, const QByteArray& table, const QByteArray& problem) {
    QTest::newRow(row) << table << "directions.csv: " + problem;
  };
  whole("empty", "", "is empty: it has to name its columns");
  whole("empty lines", "\n\n", "is empty: it has to name its columns");
  whole("dark", "u,v,x,y,r,g,b\n0,0,0,0,1,0,1\n",
        "g: has no value above 0, which would be the gain 1");
  const QByteArray fewer = "from which the others cannot be found; it needs 3 at least";
  whole("no direction", "u,v,x,y\n", "has 0 of 64 directions, " + fewer);
  whole("two directions", "u,v,x,y\n0,0,0,0\n1,0,0,0\n", "has 2 of 64 directions, " + fewer);
  whole("no direction's light", "u,v,x,y,intensity\n",
        "intensity: has no value above 0, which would be the gain 1");
  QByteArray line = "u,v,x,y\n";
  for (int k = 0; k < 8; ++k) {
    const QByteArray index = QByteArray::number(k);
    line += index + "," + index + ",0.0" + index + ",0.0" + index + "\n";
  }
  whole("a diagonal", line,
        "has 8 of 64 directions, which are too much in line for the others to be found");
}

void TestMeasuredDirections::badTables() {
  QFETCH(QByteArray, table);
  QFETCH(QByteArray, line);
  writeFile("directions.csv", table);
  QCOMPARE(errorWith("directions.csv"), line);
}

void TestMeasuredDirections::beyondTheLens() {
  PanelParams design = designOf({4, 3}, {1, 2});
  design.lens = HogelLensModel::plugin;
  design.lensParams = LensParams([] { return std::make_unique<NarrowLens>(); });
  writeFile("directions.csv", "u,v,x,y\n0,0,0.25,0.5\n0,1,-0.25,-0.625\n");
  QCOMPARE(errorOf([&] { (void)read("directions.csv", design); }),
           "directions.csv: direction (0, 1): has the slope -0.625, which the display's hogel lens "
           "does not send");
  writeFile("directions.csv", "u,v,x,y\n0,0,0.25,0.5\n0,1,-0.25,-0.5\n");
  const TwinMaps maps = read("directions.csv", design);
  QVERIFY(isPlane(maps.moveU, 1, 2, {0.25F, -0.25F}));
  QVERIFY(isPlane(maps.moveV, 1, 2, {-0.5F, 0.5F}));
}

/// Half of the measured directions of a real display. The residual is that of an independent fit.
void TestMeasuredDirections::leia() {
  const QString file =
      HOGELSCOPE_SOURCE_DIR "/../shared/data/real_displays/leia_coruscant_half.csv";
  if (!QFile::exists(file)) QSKIP("no ../shared/data/real_displays here");
  std::vector<Beam> beams;
  const QList<QByteArray> lines = contentOf(file).trimmed().split('\n');
  for (const QByteArray& line : lines.mid(1)) {
    const QList<QByteArray> cells = line.split(',');
    beams.push_back({cells[0].toInt(),
                     cells[1].toInt(),
                     {cells[2].toDouble(), cells[3].toDouble(), cells[4].toDouble()}});
  }
  QCOMPARE(beams.size(), std::size_t(32));
  const std::array fits{BruteForceFit(beams, 0, 3), BruteForceFit(beams, 1, 3)};
  QVERIFY(std::abs(slopeError(beams, fits[0], fits[1]) - 0.002729) < 1e-6);
  std::vector<std::string> warnings;
  const PanelParams design = designOf();
  const TwinMaps maps = read(file.toStdString(), design, &warnings);
  compareRays(maps, design, beams, fits);
  QCOMPARE(warnings.size(), std::size_t(1));
  QVERIFY2(QByteArray::fromStdString(warnings[0])
               .endsWith(": has 32 of 64 directions; the other 32 come from a cubic polynomial, "
                         "from which the slopes of the given ones are 0.002729 away (rms)"),
           warnings[0].c_str());
}

QTEST_APPLESS_MAIN(TestMeasuredDirections)
#include "test_measured_directions.moc"
