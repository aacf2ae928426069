// SPDX-License-Identifier: BSD-3-Clause
// The filter gives the reference's picture, executes only when it must, and reports errors.
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <QtTest>

#include "core/base/parallel.h"
#include "core/engine/scaled_view.h"
#include "core/optics/simulate.h"
#include "vtk/vtkHogelViewFilter.h"

using namespace hogelscope;

namespace {

/// 6×5 hogels of 7×4 directions with a different value everywhere.
RenderJob sampleView() {
  RenderJob job;
  job.display.hogels = {6, 5};
  job.display.directions = {7, 4};
  std::vector<std::uint8_t> values(std::size_t(3 * 6 * 5 * 7 * 4));
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::uint8_t(k * 37 % 251 + 1);
  job.lightField =
      std::make_shared<const LightField>(LightFieldSize{6, 5, 7, 4}, LightField::Values(values));
  job.state.camera.name = "sample";
  job.state.camera.eye = {0.05, 0.02, 0.6};
  job.state.camera.lookat = {0.013, 0.007, 0};  // no ray goes through a corner of four hogels
  job.state.camera.res = {61, 47};
  job.state.distortion.k1 = 0.2;
  job.state.psf.windowSize = 3;
  return job;
}

/// The filter's output from its top row on. Throws as UpdateOrThrow() does.
Image imageOf(vtkHogelViewFilter* filter) {
  filter->FloatOutputOff();
  filter->UpdateOrThrow();
  vtkImageData* output = filter->GetOutput();
  Image image(output->GetDimensions()[0], output->GetDimensions()[1]);
  vtkDataArray* seen = output->GetPointData()->GetArray("Seen");
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int row = image.height - 1 - y;
      const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
      image.seen[at] = std::uint8_t(seen->GetTuple1(vtkIdType(row) * image.width + x));
      for (int c = 0; c < 3; ++c)
        image.rgb[3 * at + std::size_t(c)] =
            std::uint8_t(output->GetScalarComponentAsDouble(x, row, 0, c));
    }
  return image;
}

std::vector<float> codeValuesOf(vtkHogelViewFilter* filter) {
  filter->FloatOutputOn();
  filter->UpdateOrThrow();
  vtkImageData* output = filter->GetOutput();
  const auto [width, height] = std::array{output->GetDimensions()[0], output->GetDimensions()[1]};
  std::vector<float> values;
  for (int y = height - 1; y >= 0; --y) {
    const auto* row = static_cast<const float*>(output->GetScalarPointer(0, y, 0));
    values.insert(values.end(), row, row + std::ptrdiff_t(3) * width);
  }
  return values;
}

/// Counts executions of the filter.
class Executions {
 public:
  explicit Executions(vtkHogelViewFilter* filter) {
    m_command->SetClientData(&m_count);
    m_command->SetCallback(
        [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    filter->AddObserver(vtkCommand::StartEvent, m_command);
  }
  [[nodiscard]] int count() const { return m_count; }

 private:
  int m_count = 0;
  vtkNew<vtkCallbackCommand> m_command;
};

}  // namespace

class TestViewFilter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { vtkObject::GlobalWarningDisplayOff(); }

  /// VTK keeps the extent that a failed execution was asked for.
  void aSmallerPictureAfterAStoppedOne() {
    const vtkNew<vtkHogelViewFilter> filter;
    bool goesOn = false;
    filter->SetProgress([&](double) { return goesOn; });
    RenderJob job = sampleView();
    for (const std::array<int, 2> res :
         {std::array{610, 470}, std::array{61, 47}, std::array{305, 600}, std::array{30, 600}}) {
      job.state.camera.res = res;
      filter->SetJob(job);
      goesOn = res[0] < 300;
      if (goesOn) {
        QVERIFY(imageOf(filter) == simulate(job));
        QCOMPARE(filter->GetOutput()->GetDimensions()[0], res[0]);
        QCOMPARE(filter->GetOutput()->GetDimensions()[1], res[1]);
      } else {
        QVERIFY_EXCEPTION_THROWN((void)imageOf(filter), Cancelled);
      }
    }
  }

  void givesTheReferencePicture() {
    const RenderJob job = sampleView();
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(job);
    const Image image = imageOf(filter);
    const Image reference = simulate(job);
    QVERIFY(image == reference);
    QVERIFY(std::count(image.seen.begin(), image.seen.end(), 255) > 500);
    QVERIFY(std::count(image.seen.begin(), image.seen.end(), 0) > 100);
  }

  void rowZeroIsTheBottom() {
    const RenderJob job = sampleView();
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(job);
    filter->Update();
    const Image reference = simulate(job);
    vtkImageData* output = filter->GetOutput();
    for (const int y : {0, 10, 46}) {
      const auto* rgb = static_cast<unsigned char*>(output->GetScalarPointer(30, y, 0));
      const std::size_t at = 3 * (std::size_t(46 - y) * 61 + 30);
      QCOMPARE(int(rgb[0]), int(reference.rgb[at]));
      QCOMPARE(int(rgb[2]), int(reference.rgb[at + 2]));
    }
  }

  void threadsDoNotMatter() {
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(sampleView());
    setThreads(1);
    const Image one = imageOf(filter);
    setThreads(0);
    filter->Modified();
    QVERIFY(imageOf(filter) == one);
  }

  void executesOnlyWhenSomethingChanged() {
    RenderJob job = sampleView();
    const vtkNew<vtkHogelViewFilter> filter;
    const Executions executions(filter);
    filter->SetJob(job);
    filter->Update();
    filter->Update();
    filter->SetJob(sampleView());  // same values, but a light field of its own
    filter->Update();
    QCOMPARE(executions.count(), 2);
    filter->SetJob(filter->GetJob());
    filter->Update();
    QCOMPARE(executions.count(), 2);
    job = filter->GetJob();
    job.state.psf.sigma = 0.9;
    filter->SetJob(job);
    filter->Update();
    QCOMPARE(executions.count(), 3);
  }

  /// A view with a tolerance or a scale has the camera's resolution all the same.
  void outputHasTheCamerasResolution() {
    RenderJob job = sampleView();
    job.method.scale = 2;
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(job);
    filter->UpdateInformation();
    const int* extent =
        filter->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    QCOMPARE(extent[1], 60);
    QCOMPARE(extent[3], 46);
    QCOMPARE(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(0));  // nothing is rendered yet
    QVERIFY(imageOf(filter) == enlarged(simulate(reduced(job)), 2, {61, 47}));
    QCOMPARE(filter->GetOutput()->GetSpacing()[0], 1.0);
  }

  void codeValuesRoundToThePicture() {
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(sampleView());
    const std::vector<float> values = codeValuesOf(filter);
    const Image image = imageOf(filter);
    QCOMPARE(values.size(), image.rgb.size());
    bool hasFraction = false;
    for (std::size_t k = 0; k < values.size(); ++k) {
      QVERIFY(std::abs(double(values[k]) - image.rgb[k]) <= 0.5001);
      hasFraction = hasFraction || values[k] != std::floor(values[k]);
    }
    QVERIFY(hasFraction);
  }

  void reportsErrorsInsteadOfThrowing() {
    RenderJob job = sampleView();
    job.state.camera.lookat = job.state.camera.eye;
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(job);
    filter->Update();
    QVERIFY(QString(filter->GetErrorMessage()).startsWith("lookat"));
    QVERIFY_EXCEPTION_THROWN((void)imageOf(filter), InputError);
    filter->SetJob(sampleView());
    QCOMPARE(imageOf(filter).width, 61);
    QCOMPARE(filter->GetErrorMessage(), "");
  }

  void withoutALightFieldIsAnError() {
    const vtkNew<vtkHogelViewFilter> filter;
    filter->Update();
    QVERIFY(*filter->GetErrorMessage() != 0);
  }

  void stopsAndStartsAgain() {
    const vtkNew<vtkHogelViewFilter> filter;
    filter->SetJob(sampleView());
    bool goesOn = false;
    filter->SetProgress([&goesOn](double) { return goesOn; });
    QVERIFY_EXCEPTION_THROWN((void)imageOf(filter), Cancelled);
    goesOn = true;
    filter->SetJob(filter->GetJob());
    QVERIFY(imageOf(filter) == simulate(sampleView()));
  }
};

QTEST_APPLESS_MAIN(TestViewFilter)
#include "test_view_filter.moc"
