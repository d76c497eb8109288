// start_demo.mjs URL PID DOCUMENT: waits until the server at URL (process PID) is ready, then makes a core of the
// document and starts it. Prints nothing if all is well; otherwise says what the server answered, status 1.
const [url, pid, document] = process.argv.slice(2);

async function call(method, path, body) {
  const options = body ? { body: JSON.stringify(body), headers: { "Content-Type": "application/json" } } : {};
  const response = await fetch(`${url}/api/v1${path}`, { method, ...options });
  if (!response.ok) throw new Error(`${method} ${path}: ${response.status} ${await response.text()}`);
  return response.json();
}

async function untilReady() {
  for (;;) {
    try {
      return await call("GET", "/health");
    } catch (error) {
      process.kill(Number(pid), 0); // throws if the server is no more
      if (error.message.startsWith("GET ")) throw error;
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
  }
}

try {
  await untilReady();
  const core = await call("POST", "/cores", { document });
  await call("POST", `/cores/${core.id}/start`);
} catch (error) {
  console.error(error.code === "ESRCH" ? "the server ended before it was ready" : error.message);
  process.exit(1);
}
