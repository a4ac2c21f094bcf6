# The site, served by nginx at port 80, and the command line `inkpanel` beside it:
#
#   docker build --tag inkpanel .
#   docker run --rm --publish 8080:80 inkpanel
#   docker run --rm --volume "$PWD:/photos" --workdir /photos inkpanel inkpanel render -o page.pdf *.jpg
FROM node:22-bookworm AS build
RUN apt-get update \
    && apt-get install --yes --no-install-recommends build-essential ca-certificates curl git python3 python3-venv \
    && rm -rf /var/lib/apt/lists/*
ENV PATH=/opt/cargo/bin:$PATH CARGO_HOME=/opt/cargo RUSTUP_HOME=/opt/rustup
RUN curl --proto '=https' --tlsv1.2 --silent --show-error --fail https://sh.rustup.rs \
    | sh -s -- -y --no-modify-path --profile minimal --default-toolchain none
WORKDIR /inkpanel
COPY . .
RUN cargo xtask build && cargo build --release --bin inkpanel

FROM nginx:1.28-bookworm
COPY docs/reference/nginx.conf /etc/nginx/conf.d/default.conf
COPY --from=build /inkpanel/www/dist /srv/inkpanel
# The command line finds its nets beside itself.
COPY --from=build /inkpanel/www/models /usr/local/bin/models
COPY --from=build /inkpanel/target/release/inkpanel /usr/local/bin/inkpanel
