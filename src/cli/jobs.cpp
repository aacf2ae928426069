// SPDX-License-Identifier: BSD-3-Clause
#include "cli/jobs.h"

#include <algorithm>
#include <ranges>

#include "cli/jobs/all_jobs.h"
#include "core/content/pattern_list.h"

namespace hogelscope {

namespace {

/// Returns a list such as "scene, spheres.", optionally with the content of each.
std::string patternList(bool isExplained) {
  std::string text;
  for (const auto& [name, help, make] : patterns()) {
    if (!text.empty()) text += isExplained ? "; " : ", ";
    text += name;
    if (isExplained) text.append(" (").append(help).append(")");
  }
  return text + ".";
}

}  // namespace

const std::vector<Job>& jobs() {
  static const std::vector<Job> all{
      {.command = Command::render,
       .name = "render",
       .help = "Writes one picture for each camera state: DIR/<name>.png.",
       .examples =
           "  hogelscope --render --session data/table1.json --output out --masks\n"
           "  hogelscope --render --session data/table1.json --output out --states 'Fig 1' \\\n"
           "             --set camera.res=[1200,1200] --set sampling.samplesPerPixel=4\n"
           "  hogelscope --render --session s.json --output out --calibration camera.yml "
           "--explain\n",
       .run = runRender},
      {.command = Command::report,
       .name = "report",
       .help = "Renders every state from the session's light field and from each test light field, "
               "and compares them: DIR/report.csv, metrics.csv, summary.csv, report.html.",
       .details = "After a stop the same command goes on where it was. Many processes, on one "
                  "machine or on many that share the folder, make one report: --shard K/N does a "
                  "part of the views; then the command without --shard takes up the parts, does "
                  "what is missing, and writes the report.",
       .examples =
           "  hogelscope --report --session s.json --test coded.png --output report\n"
           "  hogelscope --report --session s.json --test coded.png --output report --shard 2/4\n"
           "  hogelscope --report --session s.json --test coded.png --output report --images \\\n"
           "             --fail-below 30\n"
           "  hogelscope --report --session s.json --test a1.jpg … --test b4.jp2 --output report "
           "\\\n"
           "             --group JPEG=a1.jpg,a2.jpg,a3.jpg,a4.jpg \\\n"
           "             --group JPEG2000=b1.jp2,b2.jp2,b3.jp2,b4.jp2\n",
       .run = runReport},
      {.command = Command::makeCameras,
       .name = "make-cameras",
       .value = "uniform|random|normal|FILE",
       .help = "Adds camera states to a copy of the session: uniform (a grid), random or normal "
               "over a region, a distribution of your own FILE.json, or a viewer's trace FILE.csv.",
       .details = "--output may be the session itself. With --states only those of the session's "
                  "states are kept.",
       .examples =
           "  hogelscope --make-cameras uniform --session s.json --count 15 --region arc \\\n"
           "             --output arc.json\n"
           "  hogelscope --make-cameras random --session s.json --count 200 --seed 7 \\\n"
           "             --set cameraRegion.lookat=nearest --output random.json\n"
           "  hogelscope --make-cameras trace.csv --session s.json --count 600 --output "
           "viewer.json\n"
           "  hogelscope --make-cameras viewer.json --session s.json --set trace.only=I01P2R3 \\\n"
           "             --output seen.json\n",
       .sections = {"cameraSet", "cameraRegion", "trace"},
       .run = runMakeCameras},
      {.command = Command::makeTwin,
       .name = "make-twin",
       .help = "Draws the random errors of the session's twin, or of --twin, and writes a twin "
               "without random numbers: --output F.json, and F.hogels.exr with what was drawn.",
       .examples = "  hogelscope --make-twin --session data/room.json --twin unit7.json --output "
                   "drawn.json\n"
                   "  hogelscope --make-twin --session s.json --set twin.random.seed=8 \\\n"
                   "             --set twin.random.shift.sigma=5e-6 --output unit8.json\n",
       .run = runMakeTwin},
      {.command = Command::generate,
       .name = "generate",
       .value = "PATTERN",
       .help =
           "Writes a test light field of the session's display, of any size: " + patternList(false),
       .details = "PATTERN is one of: " + patternList(true),
       .examples =
           "  hogelscope --generate scene --session s.json --output scene.png\n"
           "  hogelscope --generate scene --session s.json --output noisy.png --degrade noise:2\n"
           "  hogelscope --generate directions --session views --output directions.png\n"
           "  hogelscope --generate edge --session s.json --output edge.png --set "
           "pattern.depth=0.2 \\\n"
           "             --set display.hogels=[256,256]\n",
       .sections = {"pattern"},
       .run = runGenerate},
      {.command = Command::pack,
       .name = "pack",
       .value = "LF",
       .help = "Writes a light field as a store: a tiled TIFF of which a view reads only what it "
               "sees, so that it need not fit into memory.",
       .details = "What an image of hogels does not say, display.hogels and display.directions, "
                  "--session or --set says. After a stop the same command goes on where it was.",
       .examples =
           "  hogelscope --pack large.png --session s.json --output large.tif\n"
           "  hogelscope --pack large.png --output large.tif --set display.hogels=[512,512] \\\n"
           "             --set display.directions=[600,600]\n"
           "  hogelscope --pack views --output views.tif --memory 4000\n"
           "  hogelscope --pack decoded.png --session views --output decoded.tif\n",
       .run = runPack},
      {.command = Command::exportAs,
       .name = "export",
       .value = "hogels|views|quilt|mosaic|woven|pack|rig",
       .help =
           "Writes the session's light field, of any layout or live, as hogels (one image), "
           "views (a folder), quilt, mosaic (one image of all views) or pack (a store); of a lens "
           "sheet as quilt or views, or as woven the panel's picture; or as rig "
           "the cameras that take its views, FILE.json and FILE.gltf.",
       .details = "Values keep their type: 8 or 16 bits or floats, which need .exr or .tif. What a "
                  "live scene becomes gives the same pictures as the scene itself. Only a light "
                  "field that is a store or live may be larger than memory for views, quilt "
                  "and mosaic. "
                  "After a stop pack goes on where it was. A rig needs "
                  "lightField.viewingDistance, and no light field if the display has hogels and "
                  "directions.",
       .examples = "  hogelscope --export hogels --session live.json --output hogels.png\n"
                   "  hogelscope --export pack --session live.json --output store.tif\n"
                   "  hogelscope --export quilt --session live.json --output room_qs8x6a1.png \\\n"
                   "             --set display.directions=[48,1]\n"
                   "  hogelscope --export rig --session s.json --output rig.json \\\n"
                   "             --set lightField.viewingDistance=0.6\n",
       .run = runExport},
      {.command = Command::tradeoff,
       .name = "tradeoff",
       .help = "Measures speed against accuracy of every method on the session's own states: "
               "DIR/tradeoff.csv, .png, .svg.",
       .details = "With sampling.reconstruction nearest and one ray a pixel the reference is the "
                  "display as built, with any other sampling the ideal picture. The table says on "
                  "how many pixels each figure was measured, and how well a time is known.",
       .examples =
           "  hogelscope --tradeoff --session data/table1.json --output tradeoff --budget 20\n"
           "  hogelscope --tradeoff --session data/table1.json --output ideal \\\n"
           "             --set sampling.reconstruction=quadrilinear\n",
       .run = runTradeoff},
      {.command = Command::stability,
       .name = "stability",
       .help = "Measures where methods fail: which ways to invert a lens find the right ray, which "
               "a wrong one or none, and other unstable cases: DIR/stability.csv, .png.",
       .examples = "  hogelscope --stability --output stability\n"
                   "  hogelscope --stability --output stability --calibrations cameras.json\n",
       .run = runStability},
      {.command = Command::measure,
       .name = "measure",
       .help = "Measures what the session's display can show to the eye of its first state, beside "
               "closed forms: DIR/measure.csv, measure.html, plots.",
       .details =
           "Resolution over depth, depth of field, viewing zone, crosstalk, angular profile, "
           "uniformity and more, simulated with test light; the light field is not read. "
           "After a stop the same command goes on where it was, and --shard K/N does a part, "
           "as of a report.",
       .examples = "  hogelscope --measure --session data/table1.json --output measures\n"
                   "  hogelscope --measure --session s.json --states 'front' --output measures \\\n"
                   "             --set psf.sigma=0.67 --set psf.windowSize=5\n",
       .run = runMeasure},
      {.command = Command::sweep,
       .name = "sweep",
       .value = "TABLE.json",
       .help = "Measures figures of many designs, which vary parameters of the session as a table "
               "says: DIR/sweep.csv, sweep.html, plots.",
       .details = "TABLE.json has parameters, sampling (grid or latin-hypercube, with count and "
                  "seed), figures and pareto. After a stop the same command goes on where it was, "
                  "and --shard K/N does a part, as of a report.",
       .examples = "  hogelscope --sweep table.json --session s.json --output sweep\n"
                   "  hogelscope --sweep table.json --session s.json --output sweep --shard 2/4\n",
       .run = runSweep},
      {.command = Command::depth,
       .name = "depth",
       .help = "Says whether the session's content fits its display in depth, and what scale and "
               "place would: DIR/depth.csv, .json, .png, .svg.",
       .details = "Limits are what the display can show to the eye of a state, and what is "
                  "comfortable for two eyes; proposed is what brings depth.share of the first "
                  "state's pixels within both. A live scene tells its depths; those of views come "
                  "from the shift of what they show, where that stands out.",
       .examples = "  hogelscope --depth --session data/room.json --output depth\n"
                   "  hogelscope --depth --session s.json --output depth --fit fitted.json \\\n"
                   "             --set depth.comfort=0.5 --states 'front*'\n",
       .run = runDepth},
      {.command = Command::info,
       .name = "info",
       .value = "FILE",
       .help = "Says what a session, a light field's image, a folder of views or a store is, in "
               "which order its views are, and how sure that is; or what a lens sheet's "
               "calibration (visual.json) is.",
       .details = "--output DIR writes DIR/views.png, a contact sheet: the views as their cameras "
                  "stand, with arrows.",
       .examples = "  hogelscope --info data/table1.json\n"
                   "  hogelscope --info views --json\n"
                   "  hogelscope --info views --output sheet\n"
                   "  hogelscope --info views --set lightField.pattern=view_RR_CC.png\n"
                   "  hogelscope --info large.png --set display.hogels=[512,512] \\\n"
                   "             --set display.directions=[600,600]\n",
       .run = runInfo},
      {.command = Command::plugins,
       .name = "plugins",
       .help = "Lists the plugins that are found, and says why any is refused.",
       .details = "Nothing of them is loaded: a session loads those that it names.",
       .examples = "  hogelscope --plugins\n"
                   "  hogelscope --plugins --plugins-path build/plugins-2\n",
       .run = runPlugins},
      {.command = Command::status,
       .name = "status",
       .value = "DIR",
       .help = "Says how far the report, measures or sweep in a folder is, and which shards. Exit "
               "status 0 if it is finished, 1 if not.",
       .examples = "  hogelscope --status report\n",
       .run = runStatus},
      {.command = Command::help,
       .name = "help",
       .help =
           "This text; with a job, or \"parameters\", more of it; with \"man\" or \"completion\" "
           "what man and bash read.",
       .run = runHelp},
      {.command = Command::version, .name = "version", .help = "The version.", .run = runVersion}};
  return all;
}

const Job& jobOf(Command command) {
  return *std::ranges::find(jobs(), command, &Job::command);
}

bool isOneOf(const std::vector<Command>& commands, Command command) {
  return std::ranges::find(commands, command) != commands.end();
}

bool mayNameFile(std::string_view value) {
  return std::ranges::any_of(std::views::split(value, '|'), [](const auto& part) {
    const std::string_view word(part.begin(), part.end());
    return word == "LF" || word == "PATH" || word.starts_with("FILE") || word == "TABLE.json";
  });
}

std::string optionsOf(const std::vector<Command>& commands) {
  std::string text;
  for (const Command command : commands)
    if (command != Command::window)
      text += (text.empty() ? "--" : ", --") + std::string(jobOf(command).name);
  return text;
}

}  // namespace hogelscope
