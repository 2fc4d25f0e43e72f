// Requests to the server.

async function answered(response) {
  const answer = await response.json();
  if (!response.ok) throw new Error(answer.refusal ?? `the server answers ${response.status}`);
  return answer;
}

/** What the editor begins with: the examples, and a text that was opened. */
export async function start() {
  return answered(await fetch("/api/start"));
}

/** The answer to a task; one that was given up throws an error named `AbortError`. */
export async function ask(task, request, signal) {
  const headers = { "content-type": "application/json" };
  return answered(await fetch(`/api/${task}`, { method: "POST", headers, body: JSON.stringify(request), signal }));
}

/** Requests of which only the last one counts: a new one gives up the one before it. */
export class Latest {
  #controller = new AbortController();

  async ask(task, request) {
    this.stop();
    return ask(task, request, this.#controller.signal);
  }

  stop() {
    this.#controller.abort();
    this.#controller = new AbortController();
  }
}
