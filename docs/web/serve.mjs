// serve.mjs FOLDER [PORT] - shows a folder on this machine alone, as `make serve` does.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const TYPES = {
    '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.json': 'application/json',
    '.png': 'image/png', '.webp': 'image/webp', '.svg': 'image/svg+xml', '.woff2': 'font/woff2', '.txt': 'text/plain; charset=utf-8',
    '.zip': 'application/zip',
};

// What an address asks for, '' where it is no text: %FF.
function nameIn(address) {
    try {
        return decodeURIComponent(new URL(address, 'http://localhost').pathname);
    } catch {
        return '';
    }
}

// A server of a folder's files, which does not listen yet.
//   more  pages that lie in no folder: a path's HTML
export function folderServer(folder, more = {}) {
    return http.createServer((request, answer) => {
        const name = path.normalize(nameIn(request.url));
        const file = path.join(folder, name.endsWith('/') ? `${name}index.html` : name);
        const head = (extension) => answer.writeHead(200, {'content-type': TYPES[extension] ?? 'text/plain; charset=utf-8', 'cache-control': 'no-cache'});
        if (more[name] !== undefined) {
            head('.html').end(more[name]);
        } else if (fs.existsSync(file) && fs.statSync(file).isFile()) {
            head(path.extname(file));
            fs.createReadStream(file).pipe(answer);
        } else {
            answer.writeHead(404, {'content-type': 'text/plain'}).end(`${name} is not here\n`);
        }
    });
}

if (fs.realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
    const [folder, port = '8000'] = process.argv.slice(2), server = folderServer(folder);
    server.on('error', (error) => {
        console.error(`make serve: port ${port}: ${error.code === 'EADDRINUSE' ? 'something else listens there: make serve PORT=8001' : error.message}`);
        process.exitCode = 1;
    });
    server.listen(Number(port), '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/ - Ctrl+C ends it`));
}
