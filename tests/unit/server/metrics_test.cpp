#include "server/metrics/metrics.h"

#include <gmock/gmock.h>

#include <limits>

namespace race::server {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Exposition, EscapesLabelsAndWritesNumbersAsPrometheusReadsThem) {
  Exposition to;
  to.family("race_x", "gauge", "X.");
  to.sample("race_x", {{"a", "q\"b\\n\nend"}, {"b", "é"}}, 0.1);
  to.sample("race_x", {}, std::numeric_limits<double>::infinity());
  to.sample("race_x", {}, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(
      to.text(),
      "# HELP race_x X.\n# TYPE race_x gauge\nrace_x{a=\"q\\\"b\\\\n\\nend\",b=\"é\"} 0.1\nrace_x +Inf\nrace_x NaN\n");
}

TEST(Metrics, CountByRouteAndHaveOneRowForAllThatIsNone) {
  Metrics metrics({{"GET", "/a"}}, [](Exposition&) {});
  metrics.answered("GET", "/a", 200, std::chrono::milliseconds(3));
  metrics.answered("GET", "/a", 503, std::chrono::seconds(60));
  metrics.answered("GET", "", 404, {});
  metrics.answered("BREW", "/a", 405, {});
  const std::string text = metrics.text();
  EXPECT_THAT(text, HasSubstr("race_http_requests_total{method=\"GET\",route=\"/a\",code=\"2xx\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("race_http_requests_total{method=\"GET\",route=\"/a\",code=\"5xx\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("race_http_requests_total{method=\"other\",route=\"other\",code=\"4xx\"} 2\n"));
  EXPECT_THAT(text, Not(HasSubstr("BREW")));
  EXPECT_THAT(text, HasSubstr("_bucket{method=\"GET\",route=\"/a\",le=\"0.001\"} 0\n"));
  EXPECT_THAT(text, HasSubstr("_bucket{method=\"GET\",route=\"/a\",le=\"0.005\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("_bucket{method=\"GET\",route=\"/a\",le=\"20\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("_bucket{method=\"GET\",route=\"/a\",le=\"+Inf\"} 2\n"));
}

TEST(Metrics, AClientIsHeldUntilItLeaves) {
  Metrics metrics({}, [](Exposition&) {});
  {
    const Gauge::Hold held(metrics.clients().streams);
    EXPECT_THAT(metrics.text(), HasSubstr("race_websockets{kind=\"stream\"} 1\n"));
  }
  EXPECT_THAT(metrics.text(), HasSubstr("race_websockets{kind=\"stream\"} 0\n"));
}

}  // namespace
}  // namespace race::server
